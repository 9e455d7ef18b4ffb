# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of codewheel in bash: its options and the files it opens.
_codewheel() {
    local cur
    _get_comp_words_by_ref cur
    if [[ $cur == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "--help --version" -- "$cur")
    else
        _filedir '@(codewheel|cwrec|cwcams|cwfaults)'
    fi
}
complete -F _codewheel codewheel
