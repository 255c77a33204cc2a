# Completion for bash: the subcommands and options that a program's own --help names.
_rederive() {
  local word subcommand=() current=${COMP_WORDS[COMP_CWORD]}
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    if [[ $word == [a-z]* ]] && "$1" --help 2>/dev/null | grep -qE "^  $word( |\$)"; then
      subcommand=("$word")
      break
    fi
  done
  mapfile -t COMPREPLY < <(compgen -W "$("$1" "${subcommand[@]}" --help 2>/dev/null |
    sed -nE 's/^  ([a-z][a-z-]*)( .*|$)/\1/p; s/^  (-[a-z],)?(--[a-z0-9-]+).*/\2/p')" -- "$current")
}
complete -o default -F _rederive @completed@
