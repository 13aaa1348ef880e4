toml-invalid = Das ist kein gültiges TOML: { $detail }.
    .do = Diese Zeile berichtigen.
