camera_library-taken = Kalibrierung { $name } der Kamerabibliothek{ $dated ->
        [yes] , vom { $date },
        *[no] {""}
    } { $observed ->
        [yes] geht mit ihrer Kovarianz ein
        *[no] wird festgehalten: ihre Kovarianz ist unbekannt
    }{ $poor ->
        [yes] ; Note: { $grade ->
            [not_determinable] nicht bestimmbar
            [weak] schwach
            *[other] { $grade }
        }
        *[no] {""}
    }.
    .do = Wo sie falsch ist, neu schätzen: { OPTION("library", "False", flag: "no-library") }.
