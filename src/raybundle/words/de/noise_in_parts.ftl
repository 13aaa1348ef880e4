noise_in_parts = Standardabweichungen beruhen auf weißem Rauschen: Rauschfelder benötigen die Normalgleichungen in einem Stück.
    .why = Bei Aufnahmen sind solche Standardabweichungen zu klein.
    .do = Mehr Speicher erlauben ({ OPTION("memory", "GB") }) oder die Standardabweichungen vergrößern.

noise_in_parts-factor = { $of ->
        [interior] Innere Orientierung
       *[points] Objektpunkte
    }: Faktor { NUM($factor, digits: 2) } (Median, aus einem getrennt ausgeglichenen Teil von { $images } Bildern).
