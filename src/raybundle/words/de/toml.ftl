toml-invalid = Das ist kein gültiges TOML: { $detail }.
    .do = Diese Zeile korrigieren.

toml-keys_exclude = { $first } und { $second } schließen einander aus.
    .do = Eines von beiden löschen.

toml-unknown_key = Der Schlüssel { $name } ist unbekannt.
    .do = Einen von { LIST($known, most: 24) } verwenden oder ihn löschen.
