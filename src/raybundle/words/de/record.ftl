record-unknown_entry = Das Protokoll hat keinen solchen Eintrag.
    .do = Einen von { LIST($known, most: 30) } verwenden.

record-not_a_text = Ein Eintrag des Protokolls ist ein Text.
    .do = Den Wert in Anführungszeichen schreiben.

record-too_long = Der Eintrag { $name } des Protokolls hat { $n } Zeichen; höchstens { $most } sind möglich.
    .do = Den Eintrag kürzen.
