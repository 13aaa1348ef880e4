marks_not_adjusted = Das Ergebnis enthält die gemessenen Punkte dieses Projekts nicht: sie lassen sich nicht mit ausgleichen.
    .why = Die Fotos wurden neu orientiert, und die gemessenen Punkte passen nicht dazu.
    .do = Die Punkte im Studio ansehen oder für Einzelheiten `raybundle mark adjust` ausführen.
