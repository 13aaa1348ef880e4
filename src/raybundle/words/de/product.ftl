product-gone = Ein Produkt der Stufe { $stage } ist beschädigt oder fehlt.
    .do = Denselben Befehl erneut ausführen.
