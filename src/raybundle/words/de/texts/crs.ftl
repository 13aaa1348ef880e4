crs-without_effect = Das Koordinatensystem { $system } hat keine Wirkung.
    .why = { $name ->
        [none] Positionen in einem Gitter sind nicht gegeben
        *[other] { $name } nennt ein eigenes System
    }; keiner Passpunktdatei fehlt ein System; es gibt keine Satellitenszene.
