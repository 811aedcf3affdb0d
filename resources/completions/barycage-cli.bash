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

# The first word that is neither an option nor the value of one.
_barycage_cli_file() {
  local word skip=
  file=
  for word; do
    if [[ -n $skip ]]; then
      skip=
      continue
    fi
    case $word in
      --json | --names | --list | --no-dimension | --bake | --strict | --overwrite | --fill | --y-as-written | --y-down | \
        --list-palettes | --dry-run | --quiet | --help | -q | -h | --*=* | -[oj]?*) ;;
      --) ;;
      --* | -[oj]) skip=1 ;;
      *)
        file=$word
        return
        ;;
    esac
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

_barycage_cli_options() {
  local options=
  case ${line[1]} in
    info) options="--entry --frame --json --list --names --hull-tolerance --budget --no-dimension --progress --quiet --help" ;;
    render) options="--output --entry --frame --size --points --seed --margin --cage --rest-cage --view --view-rotation --orbit --perspective --look --light --fog --slice --stereo --y-down --palette --list-palettes --colour --color
      --gamma --brightness --contrast --vibrancy --background --algorithm --iterations --part --band --resume --dry-run --time-limit --memory-limit --supersample --threads --svg --depth --bits --quality --dpi --overlay --legend --simd
      --to --progress --quiet --help" ;;
    convert) options="--entry --overwrite --bake --strict --to --columns --in-columns --points --seed --voxel --resolution --wall --fill --longest --lift --flatten --symmetry --expand --y-as-written
      --progress --quiet --help" ;;
    animate) options="--output --entry --frames --chunk --existing --fps --shutter --exposure --size --points --seed --margin --view --view-rotation --orbit --perspective --look --light --fog --slice --stereo --y-down
      --palette --colour --color --gamma --brightness --contrast --vibrancy --background --supersample --threads --bits --dpi --simd
      --progress --quiet --help" ;;
    encode) options="--output --frames --fps --dry-run --progress --quiet --help" ;;
    collage) options="--output --report --threshold --invert --maps --seconds --starts --seed --similarities --no-mirrors --angles --stem --threads --progress --quiet --help" ;;
    morph) options="--output --from --to --length --pin --progress --quiet --help" ;;
    steal) options="--output --entry --from --from-file --order --mode --map --tear --json --picture --picture-view --size --view --background --exact
      --points --seed --threads --simd --progress --quiet --help" ;;
    merge) options="--output --quality --threads --progress --quiet --help" ;;
    gallery) options="--output --entry --palette --colour --color --columns --tile --paper --page --title --progress --quiet --help" ;;
  esac
  local IFS=$' \n'
  _barycage_cli_offer $options
}

_barycage_cli_value() {
  case $1 in
    --entry | --from) _barycage_cli_names "$2" ;;
    --colour | --color) _barycage_cli_offer "$2"{density,map,address,blend,height,depth,none} ;;
    --algorithm) _barycage_cli_offer "$2"{density,chaos-game,deterministic} ;;
    --look) _barycage_cli_offer "$2"{stone,ink,cloud,x-ray,depth,normals} ;;
    --stereo) _barycage_cli_offer "$2"{side-by-side,anaglyph} ;;
    --svg) _barycage_cli_offer "$2"{structured,outline,points} ;;
    --bits) _barycage_cli_offer "$2"{8,16,32} ;;
    --overlay) _barycage_cli_offer "$2"{maps,hull,cage,fixed-points,numbers} ;;
    --page) _barycage_cli_offer "$2"{A3,A4,A5,letter,legal} ;;
    --supersample) _barycage_cli_offer "$2"{1,2,3,4} ;;
    --simd) _barycage_cli_offer "$2"{scalar,sse4,avx2,avx512,neon} ;;
    --progress) _barycage_cli_offer "$2"{always,never,auto} ;;
    --rest-cage) _barycage_cli_offer "$2"{canonical,box,rectangle,octahedron,hull,hull:8} ;;
    --background) _barycage_cli_offer "$2"{transparent,black,white} ;;
    --to)
      if [[ ${line[1]} == morph ]]; then
        _barycage_cli_names "$2"
      elif [[ ${line[1]} == render ]]; then
        _barycage_cli_offer "$2"{png,jpg,webp,tiff,exr,svg,pdf}
      else
        _barycage_cli_offer "$2"{fractint,flame,aifs,tex,csv,tsv,ply,pdf,stl,obj,glb,scad}
      fi
      ;;
    --existing) _barycage_cli_offer "$2"{skip,replace,fail} ;;
    --paper) _barycage_cli_offer "$2"{dark,light} ;;
    --columns)
      [[ ${line[1]} == gallery ]] || _barycage_cli_offer "$2"{abcdefp,abecdfp,acbdefp,pabcdef}
      ;;
    --in-columns) _barycage_cli_offer "$2"{abcdefp,abecdfp,acbdefp,pabcdef} ;;
    --resume | --report | --picture | --from-file) compopt -o default ;;
    -o | --output)
      [[ $typed != - ]] || _barycage_cli_offer -
      compopt -o default
      ;;
    --palette)
      local names
      mapfile -t names < <(command barycage-cli render --list-palettes </dev/null 2>/dev/null)
      _barycage_cli_offer "${names[@]/#/"$2"}"
      compopt -o default
      ;;
    --lift) _barycage_cli_offer "$2"auto ;;
    --symmetry) _barycage_cli_offer none mirror c{2..24} d{2..24} tetrahedral octahedral icosahedral ;;
    --budget) _barycage_cli_offer "$2"{1,10,none} ;;
    --mode) _barycage_cli_offer steal transform grid reduce posterise ;;
    --size | --points | --seed | --margin | --cage | --view | --view-rotation | --orbit | --perspective | --light | --fog | --slice | --gamma | --brightness | --contrast | --vibrancy | --iterations | --part | --band | --threads | -j | \
      --depth | --dpi | --hull-tolerance | --tile | --title | --voxel | --resolution | --wall | --longest | --flatten | --frame | --frames | --chunk | --length | --pin | \
      --threshold | --maps | --seconds | --starts | --picture-view | --order | --map | --tear | \
      --time-limit | --memory-limit) ;;
    *) return 1 ;;
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
    _barycage_cli_offer info render animate encode morph collage convert gallery merge steal help --version --help
  elif ((current == 2)) && [[ ${line[1]} == help ]]; then
    _barycage_cli_offer info render animate encode morph collage convert gallery merge steal
  elif [[ $typed == --*=* ]]; then
    _barycage_cli_value "${typed%%=*}" "${typed%%=*}="
  elif _barycage_cli_value "${line[current - 1]}"; then
    :
  elif [[ $typed == -* ]]; then
    _barycage_cli_options
  else
    compopt -o default
  fi
}
complete -F _barycage_cli barycage-cli
