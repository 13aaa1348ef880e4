product-gone = Ein Produkt der Stufe { $stage } ist beschädigt oder fehlt.
    .do = Denselben Befehl erneut ausführen.

product-needs_heights = { $command } braucht eine Oberfläche mit Höhen.
    .why = In diesem Ordner steht keine heights.tif.
    .do = Zuerst die Oberfläche mit { OPTION("dsm") } erzeugen.
