value-too_large = { $value } überschreitet { $largest }, die größte lesbare Zahl.
    .do = Die Zahl oder ihre Einheit korrigieren.

value-not_finite = { $value } ist keine endliche Zahl.
    .do = Eine endliche Zahl angeben.

value-not_a_number = { $value } ist keine Zahl.
    .do = Eine Zahl angeben.

value-not_whole = { $value } ist keine ganze Zahl von { $least } bis { $most }.
    .do = Eine ganze Zahl in diesem Bereich angeben.

value-no_text = { $value } ist kein druckbarer Text.
    .do = Einen Text in Anführungszeichen ohne Steuerzeichen angeben.

value-no_table = Hier wird eine Tabelle oder ein Objekt benannter Werte erwartet.

value-no_list = Hier wird eine Liste erwartet.

value-key_missing = Der Eintrag { $name } fehlt.
    .do = Den Eintrag ergänzen oder prüfen, ob die Datei vollständig ist.

value-count = Anzahl der Werte: { $n }; nötig: { $needed }.
    .do = So viele Werte angeben wie nötig.

value-no_whole_number = { $value } ist keine ganze Zahl oder zu groß.
    .do = Eine ganze Zahl angeben.

value-not_supported = { $value } wird nicht unterstützt.
    .do = Eines von { LIST($known, most: 20) } verwenden.

value-no_truth_value = { $value } ist weder true noch false.
    .do = true oder false schreiben.

value-list_empty = Die Liste ist leer.
    .do = Prüfen, ob die Datei vollständig ist.

value-not_above = { $value } ist nicht größer als { $limit }.
    .do = Den Wert korrigieren.

value-zero = Der Wert ist 0.
    .do = Einen Wert ungleich 0 angeben.

value-unit_unknown = Die Einheit { $unit } wird nicht unterstützt.
    .do = Eine von { LIST($known, most: 9) } verwenden.

value-no_time = { $value } ist keine Datums- und Zeitangabe.
    .do = Die Zeit wie 2021-11-07T10:29:11.950343Z schreiben.

value-size_out_of_range = { $value } liegt außerhalb des Bereichs: Eine Zahl ist 0 oder dem Betrag nach { $least } bis { $most }.
    .do = Die Zahl oder ihre Einheit korrigieren.

value-no_length = { $value } ist keine Länge.
    .do = Eine Länge wie 5mm, 0.5cm oder 0.2in angeben.

value-no_number_or_text = { $value } ist weder Zahl noch Text.
    .do = Eine Zahl oder einen Text in Anführungszeichen angeben.

value-not_one_of = { $entry } = { $given } ist unbekannt.
    .do = Eines von { LIST($known, most: 20) } angeben.

value-table_too_large = Die Tabelle oder ein Chunk von ihr hat { $size_bytes } Bytes; höchstens { $limit_bytes } werden gelesen.
