//! Completion in bash, which splits words at colons: `builtin:NAME` is put together before the program is asked.

use clap::Command;
use clap_complete::env::{Bash, EnvCompleter};
use std::ffi::OsString;
use std::io::{Error, Write};
use std::path::Path;

/// As [`Bash`], with words that have colons in them.
pub struct BashWithColons;

const SCRIPT: &str = r#"
_clap_complete_NAME() {
    local words=() i part
    for ((i = 0; i <= COMP_CWORD; i++)); do
        part="${COMP_WORDS[i]}"
        if ((i > 1)) && [[ $part == : || ${COMP_WORDS[i-1]} == : ]]; then
            words[${#words[@]}-1]+="$part"
        else
            words+=("$part")
        fi
    done
    local IFS=$'\013'
    COMPREPLY=( $( \
        _CLAP_IFS="$IFS" \
        _CLAP_COMPLETE_INDEX="$(( ${#words[@]} - 1 ))" \
        VAR="bash" \
        COMPLETER -- "${words[@]}" \
    ) )
    if [[ $? != 0 ]]; then
        unset COMPREPLY
        return
    fi
    if [[ ${words[${#words[@]}-1]} == *:* ]]; then
        COMPREPLY=( "${COMPREPLY[@]#*:}" )
    fi
    if [[ "${COMPREPLY-}" =~ [=/:]$ ]]; then
        compopt -o nospace 2> /dev/null
    fi
}
complete -o bashdefault -F _clap_complete_NAME BIN
"#;

impl EnvCompleter for BashWithColons {
    fn name(&self) -> &'static str {
        Bash.name()
    }

    fn is(&self, name: &str) -> bool {
        Bash.is(name)
    }

    fn write_registration(
        &self,
        var: &str,
        name: &str,
        bin: &str,
        completer: &str,
        buf: &mut dyn Write,
    ) -> Result<(), Error> {
        let quoted = format!("'{}'", completer.replace('\'', "'\\''"));
        let script = SCRIPT.replace("NAME", &name.replace('-', "_")).replace("BIN", bin);
        buf.write_all(script.replace("COMPLETER", &quoted).replace("VAR", var).as_bytes())
    }

    fn write_complete(
        &self,
        command: &mut Command,
        arguments: Vec<OsString>,
        current_folder: Option<&Path>,
        buf: &mut dyn Write,
    ) -> Result<(), Error> {
        Bash.write_complete(command, arguments, current_folder, buf)
    }
}
