target-no_such_id = Die Zielmarkenfamilie { $family } hat keine Nummer { $ids_missing }.
    .why = Ihre { $n } Nummern liegen zwischen { $first } und { $last }.
    .do = Nummern dieser Familie verwenden.

target-unknown_ring_family = Die Zielmarkenfamilie { $name } ist unbekannt.
    .do = Eine von { LIST($known, most: 30) } verwenden.

target-image_type = In einem Bild vom Typ { $kind } und der Form ({ $shape }) lassen sich keine Zielmarken messen.
    .do = Ein Graustufenbild mit 8 oder 16 Bit angeben.

target-unknown_tags = Die Marken { $name } sind unbekannt.
    .do = { $n ->
        [0] Eines der bekannten verwenden:
       *[other] Prüfen, ob { $near } gemeint ist; bekannt sind
     } { LIST($known, most: 30) }.

target-unknown_family = Die Zielmarkenfamilie { $name } ist unbekannt.
    .do = { $n ->
        [0] Eine der bekannten verwenden:
       *[other] Prüfen, ob { $near } gemeint ist; bekannt sind
     } { LIST($known, most: 30) }.

target-too_few_codes = Die Zielmarkenfamilie { $family } hat { $n } Zielmarken; verlangt sind { $wanted }.
    .do = Weniger Zielmarken verlangen oder eine größere Familie verwenden.

target-table_settings = { OPTION("table") } und { OPTION("bits") } beschreiben eigene Zielmarken; eines fehlt, oder andere sind genannt.
    .do = Beide angeben, ohne { OPTION("target") }{ $sheet ->
        [yes] { " " }und { OPTION("sheet") }
       *[no] { "" }
     }.
