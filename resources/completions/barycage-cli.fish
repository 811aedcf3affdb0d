# SPDX-License-Identifier: MIT
# fish completion for barycage-cli
set -l subcommands info render convert
complete -c barycage-cli -n "not __fish_seen_subcommand_from $subcommands" -f -a info -d "Say what a file holds"
complete -c barycage-cli -n "not __fish_seen_subcommand_from $subcommands" -f -a render -d "Draw an entry"
complete -c barycage-cli -n "not __fish_seen_subcommand_from $subcommands" -f -a convert -d "Write entries in another form"
complete -c barycage-cli -n "__fish_seen_subcommand_from $subcommands" -l entry -x -d "Name of an entry"
complete -c barycage-cli -l help -d "Help"
complete -c barycage-cli -n "__fish_seen_subcommand_from info" -l json -d "One JSON object"
complete -c barycage-cli -n "__fish_seen_subcommand_from info" -l hull-tolerance -x -d "Length"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l bake -d "Make what the cage shows the code"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l strict -d "What every reader takes"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l to -x -a "fractint flame" -d "Format"
set -l render "__fish_seen_subcommand_from render"
complete -c barycage-cli -n $render -s o -l output -r -d "Picture to write"
complete -c barycage-cli -n $render -l colour -x -a "density map address none" -d "What colours mean"
complete -c barycage-cli -n $render -l algorithm -x -a "density chaos-game deterministic" -d "How it is drawn"
complete -c barycage-cli -n $render -l svg -x -a "structured outline points" -d "Kind of SVG"
complete -c barycage-cli -n $render -l background -x -a "transparent black white" -d "Background"
complete -c barycage-cli -n $render -l rest-cage -x -a "canonical box hull" -d "Corners at rest"
complete -c barycage-cli -n $render -l bits -x -a "8 16" -d "Bits a channel"
complete -c barycage-cli -n $render -l supersample -x -a "1 2 3 4" -d "Cells along a pixel"
complete -c barycage-cli -n $render -l simd -x -a "scalar sse4 avx2 avx3 neon" -d "Instruction set"
complete -c barycage-cli -n $render -l progress -x -a "always never auto" -d "Progress bar"
complete -c barycage-cli -n $render -l y-down -d "y grows downwards"
for option in size points seed margin cage view palette gamma brightness iterations threads depth dpi
  complete -c barycage-cli -n $render -l $option -x
end
