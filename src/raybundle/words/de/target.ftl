target-no_such_id = Die Markenfamilie { $family } hat keine Nummer { $ids_missing }.
    .why = Die { $n } Nummern der Markenfamilie liegen zwischen { $first } und { $last }.
    .do = Nummern dieser Markenfamilie verwenden.

target-unknown_ring_family = Die Markenfamilie { $name } ist unbekannt.
    .do = Eine von { LIST($known, most: 30) } verwenden.

target-image_type = In einem Bild vom Typ { $kind } und der Dimension ({ $shape }) lassen sich keine Zielmarken messen.
    .do = Ein Graustufenbild mit 8 oder 16 Bit angeben.

target-unknown_tags = Die Markenfamilie { $name } ist unbekannt.
    .do = { $n ->
        [0] Eine der bekannten verwenden:
       *[other] Prüfen, ob { $near } gemeint ist; bekannt sind
     } { LIST($known, most: 30) }.

target-unknown_family = Die Markenfamilie { $name } ist unbekannt.
    .do = { $n ->
        [0] Eine der bekannten verwenden:
       *[other] Prüfen, ob { $near } gemeint ist; bekannt sind
     } { LIST($known, most: 30) }.

target-too_few_codes = Die Markenfamilie { $family } hat { $n } Zielmarken; verlangt sind { $wanted }.
    .do = Weniger Zielmarken verlangen oder eine größere Markenfamilie verwenden.

target-table_settings = { OPTION("table") } und { OPTION("bits") } beschreiben eigene Zielmarken; eines fehlt, oder andere sind genannt.
    .do = Beide angeben, ohne { OPTION("target") }{ $sheet ->
        [yes] { " " }und { OPTION("sheet") }
       *[no] { "" }
     }.

target-needs_photographs = { OPTION("target") } und { OPTION("dots") } gehören zu Aufnahmen; { $name } ist ein Ergebnis.
    .do = Diese Optionen weglassen.

target-family_missing = Die Markenfamilie der Zielmarken ist nicht genannt.
    .why = Markenfamilien verwenden dieselben Ringe mit verschiedenen Nummern.
    .do = { OPTION("target", "FAMILY") } ({ LIST($known, most: 40) }) oder { OPTION("table", "FILE") } und { OPTION("bits", "N") } angeben.

target-code_form = { OPTION("codes", $text) }: { $word } ist weder eine Zahl noch ein Bereich.
    .do = Einen Bereich als 7-12 schreiben.

target-code_range = { OPTION("codes") }: { $word } ist mehr als die { $most } möglichen Zielmarken.
    .do = Einen kleineren Bereich wählen.

target-code_twice = { OPTION("codes", $text) }: Eine Nummer kommt zweimal vor, oder ein Bereich läuft abwärts.
    .do = Die Liste korrigieren.

target-family_twice = Markenfamilien zweimal angegeben: { $names }.
    .do = Jede Markenfamilie einmal angeben.

target-family_ambiguous = Die Zielmarken in { $photographs } Aufnahmen passen zu mehreren Markenfamilien; Codes und Ringbreiten entscheiden nicht.
    .do = Die gedruckte Markenfamilie nennen: { OPTION("target", $best) }.

target-family_points = Markenfamilie { $family }: { $n } Punkte erkannt.

target-board_ambiguous = { $board ->
        [raster] Ein Punktraster
       *[chessboard] Ein Schachbrett
    } ist sichtbar, aber seine Größe ist mehrdeutig: { $names }.
    .why = Es muss in den meisten von { $photographs } Aufnahmen vollständig und gleich aussehen. Auch geprüft: { LIST($families, most: 30) }, AprilTag, ArUco, ChArUco.
    .do = Die Kalibriertafel nennen: { $board ->
        [raster] { OPTION("target", "circles-7x5") } oder acircles-4x11, wenn versetzt
       *[chessboard] { OPTION("target", "chessboard-9x6") }, nach ihren inneren Ecken
    }.
