# bash completion for povc(1)

_povc()
{
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} words=
    local options='--threads --spp --error --time --sampling --seed --report --reference --partial-every --resume --part --merge --tev --compare
        --max-depth --bits --transfer --alpha --output --size --format --explain --dialect --accel --accuracy --aov --crop --check
        --stats --preview --progress --quiet --verbose --color --messages --plugin-path --declare --library-path --strict --soft-lights --allow-write --limit --help --version'

    COMPREPLY=()
    case $previous in
    --bits) words='8 16' ;;
    --sampling) words='auto uniform adaptive' ;;
    --report | --reference) mapfile -t COMPREPLY < <(compgen -f -- "$current"); return ;;
    --transfer) words='scene srgb linear' ;;
    --format) words='png ppm pfm' ;;
    --dialect) words='auto course povray' ;;
    --accel) words='tree none' ;;
    --accuracy) words='certified max' ;;
    --aov) words='certainty normal depth object position albedo alpha time' ;;
    --preview) words='0 2 4 8 16' ;;
    --progress) words='auto bar json none' ;;
    --color) words='auto always never' ;;
    --messages) words='text json' ;;
    --plugin-path) mapfile -t COMPREPLY < <(compgen -d -- "$current"); return ;;
    -t | --threads | --spp | --error | --time | --seed | --partial-every | --part | --max-depth | --crop) return ;;
    *)
        case $current in
        -?*) words=$options ;;
        # Folders, .pov and .inc, .png, .ppm and .pfm.
        *) mapfile -t COMPREPLY < <(compgen -d -- "$current"; compgen -f -X '!*.p[onpf][vgm]' -- "$current"
                                    compgen -f -X '!*.inc' -- "$current"); return ;;
        esac ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}
complete -o filenames -F _povc povc
