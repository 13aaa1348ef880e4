cropped_photographs = Kamera { $camera }: Bildhauptpunkt { PERCENT($off) } % des Formats neben seiner Mitte (Grenze { PERCENT($limit) } %): { LIST($ids, most: 4) }.
    .why = Die Aufnahmen wurden beschnitten oder mit einem Shiftobjektiv gemacht; ihre Positionen hängen allein von dieser Kamera ab.
    .do = Die Aufnahmen unbeschnitten verwenden, oder die Kalibrierung des beschnittenen Formats angeben.
