# bash completion for gsbench. The candidates come from gsbench itself.
_gsbench() {
  local IFS=$'\n'
  COMPREPLY=($("${COMP_WORDS[0]}" __complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null))
}
complete -o default -F _gsbench gsbench
