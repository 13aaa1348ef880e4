noise_in_parts = Standardabweichungen beruhen auf weißem Rauschen: Rauschfelder benötigen die Normalgleichungen in einem Stück.
    .why = Bei Aufnahmen sind solche Standardabweichungen zu klein.
    .do = Mehr Speicher erlauben ({ OPTION("memory", "GB") }) oder die Standardabweichungen vergrößern.
