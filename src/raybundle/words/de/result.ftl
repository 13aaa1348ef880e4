result-not_a_folder = Eine Datei dieses Namens gibt es schon; das Ergebnis ist ein Ordner.
    .do = Einen anderen Namen für das Ergebnis wählen.

result-other_folder = Dieser Ordner ist kein Ergebnis und wird nicht überschrieben.
    .do = Einen anderen Namen wählen.

result-foreign_files = Der Ordner enthält { $n } { $n ->
     [one] Datei, die keine Ausgleichung geschrieben hat
     *[other] Dateien, die keine Ausgleichung geschrieben hat
    }: { LIST($names, most: 3) }.
    .do = Diese Dateien verschieben oder einen anderen Namen wählen.

result-no_result = Dies ist kein Ergebnisordner: result.json fehlt.
    .do = Den Ordner angeben, den die Ausgleichung geschrieben hat ({ OPTION("out") }).

result-not_of_adjustment = Die Datei ist nicht result.json einer Ausgleichung.
    .do = Erneut ausgleichen.

result-unknown_id = { $id } steht nicht in { $table }; das Ergebnis ist beschädigt.
    .do = Erneut ausgleichen.

result-no_folder = Es gibt keinen solchen Ordner.
    .do = Ein Ergebnis oder ein Projekt von orient angeben.

result-none_in_folder = Der Ordner hat weder result.json noch block.toml noch project.db.
    .do = Ein Ergebnis, einen Blockordner oder ein Projekt von orient angeben.
