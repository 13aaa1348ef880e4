setting-unknown = Die Einstellung { $name } ist unbekannt.
    .do = Eine von { LIST($known, most: 60) } angeben.

setting-wrong_kind = { $name } = { $given } ist nicht möglich: { $flag ->
        [yes] true oder false ist nötig
       *[no] ein Wert ist nötig
    }.
    .do = { $flag ->
            [yes] Für { $name } true oder false angeben
            *[no] Für { $name } einen Wert angeben
        }.

setting-several_values = { $name } = { $given } ist kein einzelner Wert.
    .do = Mehrere Namen in einen Text schreiben, durch Kommas getrennt.

setting-quotation_open = { $name } = { $given }: Ein Anführungszeichen ist nicht geschlossen.
    .do = Das Anführungszeichen schließen.

setting-impossible_character = { $name } = { $given } enthält ein Zeichen, das in Dateinamen unmöglich ist.
    .do = Den Namen neu eingeben.

setting-word_count = { $name } = { $given } hat nicht die Form { $form }.
    .do = Jeweils { $needed } { $needed ->
        [one] Wert
       *[other] Werte
    } angeben: { $form }.

setting-no_text = { $name } = { $given } ist kein Text.
    .do = Ordner und Dateien in einem Text angeben, durch Leerzeichen getrennt.

setting-no_number = { $name } = { $given } ist keine Zahl.
    .do = Eine Zahl angeben.

setting-needs_positions = { OPTION($name) } benötigt Positionen: { $gps ->
        [yes] keine Aufnahme hat eine
       *[no] { OPTION("gps", "False", flag: "no-gps") } schließt die der Aufnahmen aus
    }.
    .do = { OPTION("positions") } oder Aufnahmen mit Positionen angeben oder { OPTION($name) } weglassen.

setting-not_finite = { $name } = { $given } ist keine endliche Zahl.
    .do = Eine endliche Zahl angeben.

setting-too_small = { $name } = { $given } ist zu klein; gefordert ist { $above ->
        [yes] mehr als
        *[no] mindestens
    } { $least }.
    .do = { $above ->
            [yes] Einen Wert über { $least } angeben
            *[no] Mindestens { $least } angeben
        }.

setting-too_large = { $name } = { $given } ist zu groß; die Grenze ist { $most }.
    .do = Höchstens { $most } angeben.

setting-not_one_of = { $name } = { $given } ist kein möglicher Wert.
    .do = Einen von { LIST($known, most: 60) } angeben.

setting-value_count = { $name } = { $given }: { $n } Werte sind nötig.
    .do = { $name } mit { $n } Werten angeben.

setting-wrong_type = { $name } = { $given } ist nicht vom Typ { $type }.
    .do = { $name } als { $type } angeben.

setting-no_whole_number = { $name } = { $given } ist keine ganze Zahl.
    .do = Eine ganze Zahl angeben.

setting-no_path = { $name } ist ein Objekt vom Typ { $type }, kein Pfad.
    .do = Mit write_result oder write_block schreiben und den Ordner angeben.
