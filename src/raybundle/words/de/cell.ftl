cell-empty = Die Zelle ist leer.
    .do = Einen Wert eintragen.

cell-grouped_thousands = { $value } hat ein Trennzeichen zwischen den Tausendern.
    .do = { $plain } schreiben.

cell-not_a_number = { $value } ist keine Zahl.
    .do = Zahlen mit Dezimal{ $sign ->
        [comma] komma
       *[point] punkt
     } schreiben; unbekannte Werte leer lassen.

cell-counts_as_zero = { $value } gilt als 0; nötig ist ein Wert über 0.
    .why = Zahlen, die näher an 0 liegen als { $smallest }, werden als 0 gelesen.
    .do = Den Wert korrigieren.

cell-not_positive = { $value } ist nicht größer als 0.
    .do = Einen Wert über 0 angeben.

cell-negative_sigma = { $value } ist negativ; eine Standardabweichung ist 0 (fest) oder größer.
    .do = Den Wert korrigieren.

cell-unprintable = { $value } enthält nicht druckbare Zeichen.
    .do = Diese Zeichen löschen.

cell-no_id = { $value } ist keine gültige Kennung.
    .why = Eine Kennung ist nicht leer und hat keine Leerzeichen am Anfang oder Ende.
    .do = Die Kennung korrigieren.

cell-id_twice = Die Kennung { $id } kommt zweimal vor, zuerst in Zeile { $earlier }.
    .do = Eine der beiden Zeilen löschen oder umbenennen.

cell-unknown_id = { $id } steht nicht in { $table }.
    .do = Den Eintrag korrigieren oder in { $table } ergänzen.

cell-not_a_flag = { $value } ist weder 1 noch leer.
    .do = 1 schreiben oder die Zelle leer lassen.
