# bash completion for gsbench. The candidates come from gsbench itself; a name with a space is quoted.
_gsbench() {
  local candidate
  COMPREPLY=()
  while IFS= read -r candidate; do
    [[ $candidate != *[[:space:]\"\'\\\$\&\;\(\)]* ]] || printf -v candidate %q "$candidate"
    COMPREPLY+=("$candidate")
  done < <("${COMP_WORDS[0]/#\~/$HOME}" __complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
}
complete -o default -F _gsbench gsbench
