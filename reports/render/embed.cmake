# Writes OUTPUT, a C++ file with each text of EMBEDDED (name; file; name; file; …) as a constant of
# templates.hpp. References to source maps are removed: a report must not load other files.
set(code "#include \"templates.hpp\"\n\nnamespace gsbench::render::templates {\n")
while(EMBEDDED)
  list(POP_FRONT EMBEDDED name file)
  file(READ "${file}" text)
  string(REGEX REPLACE "/[/*]# sourceMappingURL=[^\n]*" "" text "${text}")
  string(APPEND code "const std::string_view ${name} = R\"EMBEDDED(${text})EMBEDDED\";\n")
endwhile()
string(APPEND code "}  // namespace gsbench::render::templates\n")
file(WRITE "${OUTPUT}" "${code}")
