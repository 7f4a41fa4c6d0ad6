# bash completion for povview(1)

_povview()
{
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} words=
    local options='--shot --frames --keys --bench --threads --spp --error --max-depth --dialect --plugin-path --reference --help --version'

    COMPREPLY=()
    case $previous in
    --dialect) words='auto course povray' ;;
    --shot | --reference) mapfile -t COMPREPLY < <(compgen -f -- "$current"); return ;;
    --plugin-path) mapfile -t COMPREPLY < <(compgen -d -- "$current"); return ;;
    -t | --threads | --frames | --keys | --spp | --error | --max-depth) return ;;
    *)
        case $current in
        -?*) words=$options ;;
        *) mapfile -t COMPREPLY < <(compgen -d -- "$current"; compgen -f -X '!*.pov' -- "$current"); return ;;
        esac ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}
complete -o filenames -F _povview povview
