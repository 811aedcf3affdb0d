# SPDX-License-Identifier: MIT
# bash completion for barycage-cli. Names of entries come out of files that anybody may have written: they are only
# compared and quoted, and never reach what expands words, such as compgen -W, eval or an unquoted expansion.

# Splits TEXT into `words` as the shell does, quotes taken away, nothing expanded. The last word is the one that TEXT
# ends in, perhaps empty. `open` is the quote that is still open there, `opened` where its inside begins; `active` is
# set when the shell would put something else in the place of the last word.
_barycage_cli_split() {
  local text=$1 i=0 c next word= begun=
  words=() open= opened=0 active=
  while ((i < ${#text})); do
    c=${text:i++:1}
    next=${text:i:1}
    case $open$c in
      "''" | '""') open= ;;
      "'"?) word+=$c ;;
      '"\')
        if [[ $next == [\$\`\"\\] ]]; then
          word+=$next
          ((i++))
        else
          word+=$c
        fi
        ;;
      '\')
        word+=$next
        begun=1
        ((i++))
        ;;
      "'" | '"')
        open=$c
        opened=$i
        begun=1
        ;;
      [[:space:]])
        [[ -z $begun ]] || words+=("$word")
        word= begun= active=
        ;;
      *)
        [[ $c != [\$\`\!] && $open$c != [~*?{[] ]] || active=1
        word+=$c
        begun=1
        ;;
    esac
  done
  words+=("$word")
}

# `quoted` is TEXT as it is written behind an open quote, or behind none.
_barycage_cli_quote() {
  local special instead specials
  quoted=$1
  case $2 in
    "'") specials="'" ;;
    '"') specials='\$`"!' ;;
    *) specials='\ !"#$&'\''()*;<>?[]^`{|}~' ;;
  esac
  [[ $quoted == *["$specials"]* ]] || return 0
  while [[ -n $specials ]]; do
    special=${specials:0:1}
    specials=${specials:1}
    case $2$special in
      "''") instead="'\\''" ;;
      '"!') instead="\"'!'\"" ;; # no backslash keeps the history out of double quotes
      *) instead="\\$special" ;;
    esac
    quoted=${quoted//"$special"/"$instead"}
  done
}

# Offers those words that begin with what stands before the cursor, written as its quotes ask for, without the part
# that readline keeps.
_barycage_cli_offer() {
  local word quoted
  for word; do
    [[ $word == "$typed"* ]] || continue
    _barycage_cli_quote "${word:${#kept}}" "$quote"
    # readline takes a quote at the beginning for the opening one again, and one at the end for the closing one.
    if [[ -n $quote ]]; then
      [[ -n $quoted && $quoted != "$quote"* ]] || quoted=$quote$quoted
      [[ $quoted != *"$quote" ]] || quoted+=$quote
    fi
    COMPREPLY+=("$quoted")
  done
}

# Written by barycage-cli --describe bash; ./dev describe renews it.
_barycage_cli_commands=(info render convert gallery animate encode morph merge collage steal page)

# Sets `options`: those of the command $1.
_barycage_cli_options_of() {
  case $1 in
    info)
      options=(--help --entry --json --names --list --frame --hull-tolerance --budget --no-dimension --progress --quiet)
      ;;
    render)
      options=(--help --output --entry --size --margin --view --view-rotation --y-down --orbit --perspective --look --light --fog --slice --stereo --points --supersample --seed --threads --simd --palette --colour --color --gamma --brightness --contrast --vibrancy --shadow --shadow-lean --shadow-length --background --bits --dpi --cage --rest-cage --frame --algorithm --iterations --part --band --resume --time-limit --memory-limit --to --svg --depth --quality --overlay --legend --list-palettes --dry-run --progress --quiet)
      ;;
    convert)
      options=(--help --entry --to --overwrite --bake --strict --y-as-written --columns --in-columns --points --seed --voxel --resolution --wall --fill --longest --lift --flatten --symmetry --expand --progress --quiet)
      ;;
    gallery)
      options=(--help --output --entry --palette --colour --color --title --columns --page --tile --paper --progress --quiet)
      ;;
    animate)
      options=(--help --output --entry --frames --chunk --existing --fps --shutter --exposure --size --margin --view --view-rotation --y-down --orbit --perspective --look --light --fog --slice --stereo --points --supersample --seed --threads --simd --palette --colour --color --gamma --brightness --contrast --vibrancy --shadow --shadow-lean --shadow-length --background --bits --dpi --progress --quiet)
      ;;
    encode)
      options=(--help --output --frames --dry-run --fps --progress --quiet)
      ;;
    morph)
      options=(--help --output --from --to --length --pin --progress --quiet)
      ;;
    merge)
      options=(--help --output --quality --threads --progress --quiet)
      ;;
    collage)
      options=(--help --output --report --threshold --invert --maps --seconds --starts --seed --similarities --no-mirrors --angles --stem --threads --progress --quiet)
      ;;
    steal)
      options=(--help --output --entry --from --from-file --order --mode --map --tear --json --picture --picture-view --size --view --background --exact --points --seed --threads --simd --progress --quiet)
      ;;
    page)
      options=(--help --output --entry --all --lesson --show --allow --caption --lang --size --points --progress --quiet)
      ;;
    *) options=() ;;
  esac
}

# Sets `kind` of what completes the value of $2, an option of the command $1, and `choices` of words. Fails where
# there is no value.
_barycage_cli_value_of() {
  choices=()
  case "$1 $2" in
    'info --entry' | \
      'render --entry' | \
      'convert --entry' | \
      'gallery --entry' | \
      'animate --entry' | \
      'morph --from' | \
      'morph --to' | \
      'steal --entry' | \
      'steal --from' | \
      'page --entry') kind=entries ;;
    'info --frame' | \
      'info --hull-tolerance' | \
      'render --size' | \
      'render --margin' | \
      'render --view' | \
      'render --view-rotation' | \
      'render --orbit' | \
      'render --perspective' | \
      'render --light' | \
      'render --fog' | \
      'render --slice' | \
      'render --points' | \
      'render --seed' | \
      'render -j' | \
      'render --threads' | \
      'render --gamma' | \
      'render --brightness' | \
      'render --contrast' | \
      'render --vibrancy' | \
      'render --shadow' | \
      'render --shadow-lean' | \
      'render --shadow-length' | \
      'render --dpi' | \
      'render --cage' | \
      'render --frame' | \
      'render --iterations' | \
      'render --part' | \
      'render --band' | \
      'render --time-limit' | \
      'render --memory-limit' | \
      'render --depth' | \
      'render --quality' | \
      'convert --points' | \
      'convert --seed' | \
      'convert --voxel' | \
      'convert --resolution' | \
      'convert --wall' | \
      'convert --longest' | \
      'convert --flatten' | \
      'gallery --title' | \
      'gallery --columns' | \
      'gallery --tile' | \
      'animate --frames' | \
      'animate --chunk' | \
      'animate --fps' | \
      'animate --shutter' | \
      'animate --size' | \
      'animate --margin' | \
      'animate --view' | \
      'animate --view-rotation' | \
      'animate --orbit' | \
      'animate --perspective' | \
      'animate --light' | \
      'animate --fog' | \
      'animate --slice' | \
      'animate --points' | \
      'animate --seed' | \
      'animate -j' | \
      'animate --threads' | \
      'animate --gamma' | \
      'animate --brightness' | \
      'animate --contrast' | \
      'animate --vibrancy' | \
      'animate --shadow' | \
      'animate --shadow-lean' | \
      'animate --shadow-length' | \
      'animate --dpi' | \
      'encode --fps' | \
      'morph --length' | \
      'morph --pin' | \
      'merge --quality' | \
      'merge -j' | \
      'merge --threads' | \
      'collage --threshold' | \
      'collage --maps' | \
      'collage --seconds' | \
      'collage --starts' | \
      'collage --seed' | \
      'collage -j' | \
      'collage --threads' | \
      'steal --order' | \
      'steal --map' | \
      'steal --tear' | \
      'steal --picture-view' | \
      'steal --size' | \
      'steal --view' | \
      'steal --points' | \
      'steal --seed' | \
      'steal -j' | \
      'steal --threads' | \
      'page --caption' | \
      'page --size' | \
      'page --points') kind=nothing ;;
    'info --budget') kind=words choices=(1 10 none) ;;
    'info --progress' | \
      'render --progress' | \
      'convert --progress' | \
      'gallery --progress' | \
      'animate --progress' | \
      'encode --progress' | \
      'morph --progress' | \
      'merge --progress' | \
      'collage --progress' | \
      'steal --progress' | \
      'page --progress') kind=words choices=(always never auto) ;;
    'render -o' | \
      'render --output' | \
      'render --resume' | \
      'gallery -o' | \
      'gallery --output' | \
      'animate -o' | \
      'animate --output' | \
      'encode -o' | \
      'encode --output' | \
      'morph -o' | \
      'morph --output' | \
      'merge -o' | \
      'merge --output' | \
      'collage -o' | \
      'collage --output' | \
      'collage --report' | \
      'steal -o' | \
      'steal --output' | \
      'steal --from-file' | \
      'steal --picture' | \
      'page -o' | \
      'page --output' | \
      'page --lesson') kind=files ;;
    'render --look' | \
      'animate --look') kind=words choices=(stone ink cloud x-ray depth normals) ;;
    'render --stereo' | \
      'animate --stereo') kind=words choices=(side-by-side anaglyph) ;;
    'render --supersample' | \
      'animate --supersample') kind=words choices=(1 2 3 4) ;;
    'render --simd' | \
      'animate --simd' | \
      'steal --simd') kind=words choices=(scalar sse4 avx2 avx512 neon) ;;
    'render --palette' | \
      'gallery --palette' | \
      'animate --palette') kind=palettes ;;
    'render --colour' | \
      'render --color' | \
      'animate --colour' | \
      'animate --color') kind=words choices=(density map address blend height depth none) ;;
    'render --background' | \
      'animate --background' | \
      'steal --background') kind=words choices=(transparent black white) ;;
    'render --bits' | \
      'animate --bits') kind=words choices=(8 16 32) ;;
    'render --rest-cage') kind=words choices=(canonical box rectangle octahedron hull) ;;
    'render --algorithm') kind=words choices=(density chaos-game deterministic) ;;
    'render --to') kind=words choices=(png jpg webp tiff exr svg pdf) ;;
    'render --svg') kind=words choices=(structured outline points) ;;
    'render --overlay') kind=words choices=(maps hull cage fixed-points numbers) ;;
    'convert --to') kind=words choices=(fractint flame aifs tex csv tsv ply pdf stl obj glb scad) ;;
    'convert --columns' | \
      'convert --in-columns') kind=words choices=(abcdefp abecdfp acbdefp pabcdef) ;;
    'convert --lift') kind=words choices=(auto) ;;
    'convert --symmetry') kind=words choices=(none mirror c2 c3 c4 c5 c6 c7 c8 c9 c10 c11 c12 c13 c14 c15 c16 c17 c18 c19 c20 c21 c22 c23 c24 d2 d3 d4 d5 d6 d7 d8 d9 d10 d11 d12 d13 d14 d15 d16 d17 d18 d19 d20 d21 d22 d23 d24 tetrahedral octahedral icosahedral) ;;
    'gallery --colour' | \
      'gallery --color') kind=words choices=(density map address blend none) ;;
    'gallery --page') kind=words choices=(A3 A4 A5 letter legal) ;;
    'gallery --paper') kind=words choices=(dark light) ;;
    'animate --existing') kind=words choices=(skip replace fail) ;;
    'animate --exposure') kind=words choices=(fixed smooth each) ;;
    'encode --frames') kind=words choices=(all) ;;
    'collage --angles') kind=words choices=(60 90) ;;
    'steal --mode') kind=words choices=(steal transform grid reduce posterise) ;;
    'page --show') kind=words choices=(figure table all) ;;
    'page --allow') kind=words choices=(cage maps code cage,maps cage,code none) ;;
    'page --lang') kind=words choices=(en de es fr mk) ;;
    *) return 1 ;;
  esac
}
# What is written ends here.

# The first word behind the command that is neither an option nor the value of one.
_barycage_cli_file() {
  local word skip= kind choices
  file=
  for word; do
    if [[ -n $skip ]]; then
      skip=
    elif [[ $word == -- ]]; then
      :
    elif [[ $word == -* ]]; then
      ! _barycage_cli_value_of "${line[1]}" "$word" || skip=1
    else
      file=$word
      return
    fi
  done
}

_barycage_cli_names() {
  local file names
  _barycage_cli_file "${line[@]:2}"
  [[ $file != '~/'* ]] || file=$HOME/${file:2}
  [[ -f $file ]] || return 0
  mapfile -t names < <(command barycage-cli info --names -- "$file" </dev/null 2>/dev/null)
  _barycage_cli_offer "${names[@]/#/"$1"}"
}

# Completes the value of the option $1, which $2 stands before in the same word.
_barycage_cli_value() {
  local kind choices
  _barycage_cli_value_of "${line[1]}" "$1" || return 1
  case $kind in
    entries) _barycage_cli_names "$2" ;;
    words) _barycage_cli_offer "${choices[@]/#/"$2"}" ;;
    palettes)
      mapfile -t choices < <(command barycage-cli render --list-palettes </dev/null 2>/dev/null)
      _barycage_cli_offer "${choices[@]/#/"$2"}"
      compopt -o default
      ;;
    files)
      [[ $typed != - ]] || _barycage_cli_offer -
      compopt -o default
      ;;
  esac
}

_barycage_cli() {
  local before=${COMP_LINE:0:COMP_POINT} behind words open opened active line typed kept quote
  COMPREPLY=()
  _barycage_cli_split "x${COMP_LINE:COMP_POINT}"
  behind=("${words[@]:1}")
  _barycage_cli_split "$before"
  line=("${words[@]}" "${behind[@]}")
  typed=${words[${#words[@]} - 1]}
  local current=$((${#words[@]} - 1)) start=$((${#before} - ${#2}))
  # readline replaces what is behind an open quote or, outside of quotes, behind the last : or =.
  [[ -z $open ]] || ((opened <= start)) || start=$opened
  _barycage_cli_split "${before:0:start}"
  kept=${words[${#words[@]} - 1]} quote=$open
  [[ -z $active && $typed == "$kept"* ]] || return 0

  if ((current == 1)); then
    _barycage_cli_offer "${_barycage_cli_commands[@]}" help --version --help
  elif ((current == 2)) && [[ ${line[1]} == help ]]; then
    _barycage_cli_offer "${_barycage_cli_commands[@]}"
  elif [[ $typed == --*=* ]]; then
    _barycage_cli_value "${typed%%=*}" "${typed%%=*}="
  elif _barycage_cli_value "${line[current - 1]}"; then
    :
  elif [[ $typed == -* ]]; then
    local options
    _barycage_cli_options_of "${line[1]}"
    _barycage_cli_offer "${options[@]}"
  else
    compopt -o default
  fi
}
complete -F _barycage_cli barycage-cli
