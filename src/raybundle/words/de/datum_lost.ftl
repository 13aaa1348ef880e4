datum_lost = Das frühere Ergebnis in diesem Ordner hatte ein Datum, das diesem fehlt: { datum-part }.
    .why = Der letzte Lauf hatte Passpunkte, Positionen oder Maßstabsstrecken, die jetzt fehlen oder nicht in die Ausgleichung eingehen.
    .do = Passpunkte, Positionen oder Maßstabsstrecken erneut angeben ({ OPTION("control") }, { OPTION("scale_bar") }) oder eine andere { OPTION("out") }.
