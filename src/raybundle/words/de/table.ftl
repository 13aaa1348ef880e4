table-more_errors = Es gibt weitere Fehler; der Rest der Datei wurde nicht gelesen.

table-too_few_rows = Zeilen der Tabelle: { $n }; nötig: { $least }.
    .do = Zeilen ergänzen oder die Datei löschen, wenn sie nicht nötig ist.

table-empty = Die Datei ist leer.
    .do = Kopfzeile und Zeilen schreiben oder die Datei löschen, wenn sie nicht nötig ist.

table-line_too_long = Das ist keine Tabelle: mehr als { $limit_bytes } Bytes { $empty ->
        [yes] leerer Zeilen
       *[no] in einer Zeile
     }.
    .do = Die Tabelle neu exportieren.

table-no_header = Die erste Zeile enthält Werte ({ LIST($header, most: 3) }) und keine Spaltennamen.
    .do = Eine Kopfzeile mit { LIST($needed, most: 20) } schreiben.

table-unknown_column = Die Spalte { $name } ist unbekannt.
    .do = Die Spalte umbenennen oder löschen; Spalten sind { LIST($needed, most: 20) }, wahlweise { LIST($optional, most: 20) }.

table-column_twice = Die Spalte { $name } kommt zweimal vor.
    .do = Eine der beiden löschen oder umbenennen.

table-columns_missing = Fehlende Spalten: { $names }.
    .why = Die Datei hat { LIST($header, most: 12) }.
    .do = Die Spalten ergänzen; nötig sind { LIST($needed, most: 20) }.

table-empty_line = Die Zeile ist leer.
    .do = Die Zeile löschen.

table-cell_count = Zellen dieser Zeile: { $n }; Spalten der Kopfzeile: { $needed }.
    .why = Die Zeile ist { $row }.
    .do = { $hint ->
        [commas] Zellen durch Kommas trennen
        [semicolons] Zellen wie in der Kopfzeile durch Semikolons trennen
        [tabs] Zellen wie in der Kopfzeile durch Tabulatoren trennen
        [decimal_comma] Dezimalpunkt statt Komma verwenden
       *[none] Zellen ergänzen oder löschen
     }.

table-pair_twice = Dieselben Werte von { LIST($names, most: 2) } stehen in Zeile { $earlier }.
    .do = Eine der beiden Zeilen löschen.

table-time_order = Auf die Zeit { NUM($before_s, digits: 10) } s folgt { NUM($time_s, digits: 10) } s.
    .do = Die Zeilen nach der Zeit ordnen und doppelte Zeiten löschen.

table-row_unreadable = Die Zeile ist nicht lesbar ({ $detail }).
    .do = Ein offenes Anführungszeichen schließen oder prüfen, ob die Datei eine Tabelle ist.

table-quote_open = Eine Zelle geht über das Zeilenende hinaus.
    .do = Das offene Anführungszeichen schließen.

table-separator_unknown = { $value } nennt kein Trennzeichen von Tabellen.
    .do = Zellen durch Kommas, Semikolons oder Tabulatoren trennen.

table-two_decimal_signs = Verschiedene Dezimalzeichen: { $later } hier, { $first } in Zeile { $first_line }, Spalte { $first_column }.
    .do = Alle Zahlen mit einem Dezimalzeichen und ohne Tausendertrennzeichen schreiben.

table-csv_and_parquet = Die Tabelle ist doppelt: { $csv } liegt im selben Ordner.
    .do = Eine der beiden Dateien anderswohin verschieben.

table-columns_together = Die Spalten { $names } brauchen die Spalten { $missing }.
    .do = Die fehlenden Spalten ergänzen oder { $names } löschen.

table-three_angles = Drei Winkel einer Art und einer Einheit sind nötig.
    .do = { LIST($choices, most: 6) } angeben oder dieselben mit _gon oder _rad.

table-one_position = Die Tabelle braucht entweder { $grid } oder { $geographic }.
    .do = Genau eine dieser Spaltengruppen angeben.

table-not_increasing = { NUM($value, digits: 10) } folgt auf { NUM($before, digits: 10) }; die Spalte muss ansteigen.
    .do = Die Zeilen nach dieser Spalte sortieren und wiederholte Werte löschen.

table-no_such_column = Die Tabelle hat keine Spalte { $name }.
    .do = Eine von { LIST($known, most: 40) } angeben.
