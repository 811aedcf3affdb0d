# SPDX-License-Identifier: MIT
# fish completion for barycage-cli

# Names come out of files that anybody may have written: fish compares and quotes what a function prints, and expands
# none of it.
function __barycage_cli_names
    set -l tokens (commandline -op)
    set -l skip 0
    for word in $tokens[3..]
        if test $skip = 1
            set skip 0
            continue
        end
        switch $word
            case --json --names --list --no-dimension --bake --strict --overwrite --fill --y-as-written --y-down --list-palettes --dry-run --quiet --help -q -h '--*=*' --
            case -o -j '--*'
                set skip 1
            case '-o*' '-j*'
            case '*'
                set -l file (string replace -r '^~/' "$HOME/" -- $word)
                test -f "$file"; or return
                # Without a quote fish keeps a ~ that means a home, and blanks of other scripts that part words.
                set -l unsafe '^~|[^\P{Z} ]'
                string match -qr '^[\'"]' -- (commandline -ct); and set unsafe '^$'
                command barycage-cli info --names -- "$file" </dev/null 2>/dev/null | string match -vr $unsafe
                return
        end
    end
end

set -l subcommands info render animate encode morph collage convert gallery merge steal
complete -c barycage-cli -n "not __fish_seen_subcommand_from $subcommands" -f -a info -d "Show what a file contains"
complete -c barycage-cli -n "not __fish_seen_subcommand_from $subcommands" -f -a render -d "Draw an entry"
complete -c barycage-cli -n "not __fish_seen_subcommand_from $subcommands" -f -a animate -d "Draw the frames of an animation"
complete -c barycage-cli -n "not __fish_seen_subcommand_from $subcommands" -f -a convert -d "Convert entries to another format"
complete -c barycage-cli -n "not __fish_seen_subcommand_from $subcommands" -f -a gallery -d "Draw all entries on one sheet"
complete -c barycage-cli -n "not __fish_seen_subcommand_from $subcommands" -f -a merge -d "Merge the parts of a picture"
complete -c barycage-cli -n "__fish_seen_subcommand_from info render animate convert gallery steal" -l entry -x -a "(__barycage_cli_names)" -d "Name of an entry"
complete -c barycage-cli -n "not __fish_seen_subcommand_from $subcommands" -f -a help -d "Show the options of a command"
complete -c barycage-cli -l help -d "Help"
complete -c barycage-cli -n "__fish_seen_subcommand_from $subcommands" -s q -l quiet -d "No progress bar and no warnings"
complete -c barycage-cli -n "__fish_seen_subcommand_from info" -l list -d "Print one line for each entry"
complete -c barycage-cli -n "__fish_seen_subcommand_from info" -l budget -x -a "1 10 none" -d "Time for each property"
complete -c barycage-cli -n "__fish_seen_subcommand_from info" -l no-dimension -d "Leave out the affinity dimension"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l overwrite -d "Replace input files"
complete -c barycage-cli -n "not __fish_seen_subcommand_from $subcommands" -l version -d "Version"
complete -c barycage-cli -n "__fish_seen_subcommand_from info" -l json -d "Print one JSON object"
complete -c barycage-cli -n "__fish_seen_subcommand_from info" -l names -d "Print only the names"
complete -c barycage-cli -n "__fish_seen_subcommand_from info" -l progress -x -a "always never auto" -d "Progress bar"
complete -c barycage-cli -n "__fish_seen_subcommand_from info" -l hull-tolerance -x -d "Length"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l bake -d "Bake the cage into the code"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l strict -d "Write files that every program can read"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l to -x -a "fractint flame aifs tex csv tsv ply pdf stl obj glb scad" -d "Format"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l columns -x -a "abcdefp abecdfp acbdefp pabcdef" -d "Order of the columns to write"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l in-columns -x -a "abcdefp abecdfp acbdefp pabcdef" -d "Order of the columns to read"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l points -x -d "Number of points to write"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l seed -x -d "Seed of the random numbers"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l voxel -x -d "Size of a voxel in mm"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l resolution -x -d "Voxels along the longest side"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l wall -x -d "Smallest thickness in mm"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l fill -d "Fill closed cavities"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l longest -x -d "Longest side in mm"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l lift -x -a auto -d "Lift to space, with this factor of z"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l flatten -x -d "Project to the plane, along a direction"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l symmetry -x -a "none mirror c2 c3 c4 c5 c6 c8 c12 d2 d3 d4 d5 d6 d8 d12 tetrahedral octahedral icosahedral" -d "Symmetry group of the entries"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l expand -d "Write the plain maps of a symmetry or of linked maps"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l y-as-written -d "Keep the y of flames as written"
complete -c barycage-cli -n "__fish_seen_subcommand_from convert" -l progress -x -a "always never auto" -d "Progress bar"
complete -c barycage-cli -n "__fish_seen_subcommand_from info render" -l frame -x -d "Moment of an animation"
set -l animate "__fish_seen_subcommand_from animate"
complete -c barycage-cli -n $animate -s o -l output -r -d "Pictures to write, such as NAME.####.png, or a video"
complete -c barycage-cli -n "__fish_seen_subcommand_from animate encode" -l fps -x -d "Frames per second of a video"
complete -c barycage-cli -n $animate -l shutter -x -d "Motion blur in degrees"
complete -c barycage-cli -n $animate -l exposure -x -a "smooth fixed each" -d "Brightness"
complete -c barycage-cli -n "not __fish_seen_subcommand_from $subcommands" -f -a encode -d "Make a video from pictures"
complete -c barycage-cli -n "__fish_seen_subcommand_from encode" -s o -l output -r -d "Video to write"
complete -c barycage-cli -n "__fish_seen_subcommand_from encode" -l frames -x -a all -d "File numbers, or all"
complete -c barycage-cli -n "__fish_seen_subcommand_from encode" -l progress -x -a "always never auto" -d "Progress bar"
complete -c barycage-cli -n $animate -l frames -x -d "File numbers"
complete -c barycage-cli -n $animate -l chunk -x -d "Every n-th frame"
complete -c barycage-cli -n $animate -l existing -x -a "skip replace fail" -d "What happens to files that exist"
complete -c barycage-cli -n "not __fish_seen_subcommand_from $subcommands" -f -a morph -d "Turn one entry into another"
set -l morph "__fish_seen_subcommand_from morph"
complete -c barycage-cli -n $morph -s o -l output -r -d "File to write"
complete -c barycage-cli -n $morph -l from -x -a "(__barycage_cli_names)" -d "Entry at frame 0"
complete -c barycage-cli -n $morph -l to -x -a "(__barycage_cli_names)" -d "Entry at the last frame"
complete -c barycage-cli -n $morph -l progress -x -a "always never auto" -d "Progress bar"
complete -c barycage-cli -n $morph -l length -x -d "Last frame"
complete -c barycage-cli -n $morph -l pin -x -d "Pair of maps"
complete -c barycage-cli -n "not __fish_seen_subcommand_from $subcommands" -f -a collage -d "Find a system for a picture"
set -l collage "__fish_seen_subcommand_from collage"
complete -c barycage-cli -n $collage -s o -l output -r -d "File to write"
complete -c barycage-cli -n $collage -l report -r -d "Write how well it fits"
complete -c barycage-cli -n $collage -l threshold -x -d "Grey level of the shape"
complete -c barycage-cli -n $collage -l invert -d "Trace the background"
complete -c barycage-cli -n $collage -l maps -x -d "Number of maps"
complete -c barycage-cli -n $collage -l seconds -x -d "How long to search"
complete -c barycage-cli -n $collage -l starts -x -d "Number of random starts"
complete -c barycage-cli -n $collage -l seed -x -d "Seed of the random starts"
complete -c barycage-cli -n $collage -l similarities -d "Only maps that keep angles"
complete -c barycage-cli -n $collage -l no-mirrors -d "No maps that reflect"
complete -c barycage-cli -n $collage -l angles -x -a "60 90" -d "Multiples by which maps rotate"
complete -c barycage-cli -n $collage -l stem -d "First map is a line"
complete -c barycage-cli -n $collage -s j -l threads -x -d "Threads"
complete -c barycage-cli -n $collage -l progress -x -a "always never auto" -d "Progress bar"
complete -c barycage-cli -n $collage -s q -l quiet -d "No progress bar and no warnings"
complete -c barycage-cli -n "not __fish_seen_subcommand_from $subcommands" -f -a steal -d "Paint an entry with the colours of a picture"
set -l steal "__fish_seen_subcommand_from steal"
complete -c barycage-cli -n $steal -s o -l output -r -d "Picture to write"
complete -c barycage-cli -n $steal -l from -x -a "(__barycage_cli_names)" -d "Entry on which the picture is placed"
complete -c barycage-cli -n $steal -l from-file -r -d "File with that entry"
complete -c barycage-cli -n $steal -l picture -r -d "Picture to take colours from"
complete -c barycage-cli -n $steal -l picture-view -x -d "Section shown by the picture"
complete -c barycage-cli -n $steal -l order -x -d "Order of the maps, the one on top first"
complete -c barycage-cli -n $steal -l mode -x -a "steal transform grid reduce posterise" -d "How the picture is placed"
complete -c barycage-cli -n $steal -l map -x -d "Print the images of points"
complete -c barycage-cli -n $steal -l tear -x -d "Print the tear"
complete -c barycage-cli -n $steal -l json -d "Print JSON"
complete -c barycage-cli -n $steal -l exact -d "Exact, without samples"
complete -c barycage-cli -n $steal -l size -x -d "Width and height"
complete -c barycage-cli -n $steal -l view -x -d "Centre and height"
complete -c barycage-cli -n $steal -l background -x -a "transparent black white" -d "Background"
complete -c barycage-cli -n $steal -l points -x -d "Samples"
complete -c barycage-cli -n $steal -l seed -x -d "Seed of the random numbers"
complete -c barycage-cli -n $steal -s j -l threads -x -d "Threads"
complete -c barycage-cli -n $steal -l simd -x -a "scalar sse4 avx2 avx512 neon" -d "Instruction set"
complete -c barycage-cli -n $steal -l progress -x -a "always never auto" -d "Progress bar"
set -l render "__fish_seen_subcommand_from render"
complete -c barycage-cli -n $render -s o -l output -r -a - -d "Picture to write"
complete -c barycage-cli -n "__fish_seen_subcommand_from render animate" -l colour -x -a "density map address blend height depth none" -d "What the colours show"
complete -c barycage-cli -n $render -l algorithm -x -a "density chaos-game deterministic" -d "Algorithm"
complete -c barycage-cli -n "__fish_seen_subcommand_from render animate" -l look -x -a "stone ink cloud x-ray depth normals" -d "Look of a system in space"
complete -c barycage-cli -n "__fish_seen_subcommand_from render animate" -l stereo -x -a "side-by-side anaglyph" -d "Draw for both eyes"
complete -c barycage-cli -n $render -l svg -x -a "structured outline points" -d "Kind of vector graphics"
complete -c barycage-cli -n $render -l to -x -a "png jpg webp tiff exr svg pdf" -d "Format"
complete -c barycage-cli -n "__fish_seen_subcommand_from render animate" -l background -x -a "transparent black white" -d "Background"
complete -c barycage-cli -n $render -l rest-cage -x -a "canonical box rectangle octahedron hull" -d "Corners at rest"
complete -c barycage-cli -n "__fish_seen_subcommand_from render animate" -l palette -r -a "(command barycage-cli render --list-palettes </dev/null 2>/dev/null)" -d "Palette by name or from a file"
complete -c barycage-cli -n $render -l list-palettes -d "List the palettes"
complete -c barycage-cli -n "__fish_seen_subcommand_from render animate" -l color -x -a "density map address blend none" -d "What the colours show"
complete -c barycage-cli -n "__fish_seen_subcommand_from render animate" -s j -l threads -x -d "Threads"
complete -c barycage-cli -n "__fish_seen_subcommand_from render animate" -l bits -x -a "8 16 32" -d "Bits per channel"
complete -c barycage-cli -n "__fish_seen_subcommand_from render animate" -l supersample -x -a "1 2 3 4" -d "Cells along each side of a pixel"
complete -c barycage-cli -n "__fish_seen_subcommand_from render animate" -l simd -x -a "scalar sse4 avx2 avx512 neon" -d "Instruction set"
complete -c barycage-cli -n "__fish_seen_subcommand_from render animate" -l progress -x -a "always never auto" -d "Progress bar"
complete -c barycage-cli -n "__fish_seen_subcommand_from render animate" -l y-down -d "The y axis points down"
for option in size points seed margin cage view view-rotation orbit perspective light fog slice gamma brightness contrast vibrancy iterations depth dpi
  complete -c barycage-cli -n $render -l $option -x
end
for option in size points seed margin view view-rotation orbit perspective light fog slice gamma brightness contrast vibrancy dpi
  complete -c barycage-cli -n $animate -l $option -x
end
complete -c barycage-cli -n $render -l quality -x -d "Quality of JPEG and WebP"
complete -c barycage-cli -n $render -l overlay -x -a "maps hull cage fixed-points numbers" -d "Parts to draw over the picture"
complete -c barycage-cli -n $render -l legend -d "Table of maps beside the picture"
complete -c barycage-cli -n $render -l part -x -d "Part I of N, into a .sum file"
complete -c barycage-cli -n $render -l band -x -d "Band J of M of the rows, into a .sum file"
complete -c barycage-cli -n $render -l resume -r -d "Add points to the picture in a .sum file"
complete -c barycage-cli -n "__fish_seen_subcommand_from render encode" -l dry-run -d "Report what is wrong, write nothing"
complete -c barycage-cli -n $render -l time-limit -x -d "Limit of time in seconds"
complete -c barycage-cli -n $render -l memory-limit -x -d "Limit of memory in megabytes"
set -l merge "__fish_seen_subcommand_from merge"
complete -c barycage-cli -n $merge -s o -l output -r -d "Picture or sum to write"
complete -c barycage-cli -n $merge -l quality -x -d "Quality of JPEG and WebP"
complete -c barycage-cli -n $merge -s j -l threads -x -d "Threads"
complete -c barycage-cli -n $merge -l progress -x -a "always never auto" -d "Progress bar"
set -l gallery "__fish_seen_subcommand_from gallery"
complete -c barycage-cli -n $gallery -s o -l output -r -a - -d "Sheet to write"
complete -c barycage-cli -n $gallery -l palette -r -a "(command barycage-cli render --list-palettes </dev/null 2>/dev/null)" -d "Palette by name or from a file"
complete -c barycage-cli -n $gallery -l colour -x -a "density map address blend none" -d "What the colours show"
complete -c barycage-cli -n $gallery -l color -x -a "density map address blend none" -d "What the colours show"
complete -c barycage-cli -n $gallery -l columns -x -d "Pictures side by side"
complete -c barycage-cli -n $gallery -l tile -x -d "Width and height of a picture"
complete -c barycage-cli -n $gallery -l paper -x -a "dark light" -d "Background"
complete -c barycage-cli -n $gallery -l page -x -a "A3 A4 A5 letter legal" -d "Pages of a PDF"
complete -c barycage-cli -n $gallery -l title -x -d "Title above the sheet"
complete -c barycage-cli -n $gallery -l progress -x -a "always never auto" -d "Progress bar"
