report-unknown_language = Es gibt keine Berichte in der Sprache { $language }.
    .do = Eine von { LIST($known, most: 20) } angeben.

report-no_table = Das Ergebnis hat keine Tabelle { $name }.
    .do = Eine von { LIST($known, most: 60) } angeben.
