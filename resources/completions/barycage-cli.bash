# SPDX-License-Identifier: MIT
# bash completion for barycage-cli

_barycage_cli() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} subcommand=${COMP_WORDS[1]}
  local file word values= options=
  case $previous in
    --entry)
      for word in "${COMP_WORDS[@]:2}"; do [ -f "$word" ] && file=$word && break; done
      [ -n "$file" ] && values=$(sed -n 's/^[[:blank:]]*\([^;[:blank:]({]\{1,\}\)[^;]*{.*/\1/p' "$file" 2>/dev/null) ;;
    --colour) values="density map address none" ;;
    --algorithm) values="density chaos-game deterministic" ;;
    --svg) values="structured outline points" ;;
    --bits) values="8 16" ;;
    --supersample) values="1 2 3 4" ;;
    --simd) values="scalar sse4 avx2 avx3 neon" ;;
    --progress) values="always never auto" ;;
    --rest-cage) values="canonical box hull hull:8" ;;
    --background) values="transparent black white" ;;
    --to) [ "$subcommand" = render ] && values="png svg pdf" || values="fractint flame aifs csv tsv ply pdf" ;;
    --paper) values="dark light" ;;
    --columns|--in-columns) values="abcdefp abecdfp acbdefp pabcdef" ;;
    -o|--output) COMPREPLY=($(compgen -f -W - -- "$current")); return ;;
  esac
  if [ -n "$values" ]; then
    COMPREPLY=($(compgen -W "$values" -- "$current"))
    return
  fi
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "info render convert gallery --version --help" -- "$current"))
    return
  fi
  case $subcommand in
    info) options="--entry --json --hull-tolerance --progress --help" ;;
    render) options="--output --entry --size --points --seed --margin --cage --rest-cage --view --y-down --palette --colour
      --gamma --brightness --background --algorithm --iterations --supersample --threads --svg --depth --bits --dpi --simd
      --to --progress --help" ;;
    convert) options="--entry --bake --strict --to --columns --in-columns --points --seed --y-as-written --progress
      --help" ;;
    gallery) options="--output --columns --tile --paper --title --progress --help" ;;
  esac
  if [[ $current == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$current"))
  else
    COMPREPLY=($(compgen -f -- "$current"))
  fi
}
complete -o filenames -F _barycage_cli barycage-cli
