flight_line-count = Für { $images } Bilder sind { $n } Nummern von Flugstreifen angegeben.
    .do = Für jedes Bild eine Nummer angeben.

flight_line-too_few_images = Kein Flugstreifen hat { $least } Bilder mit beobachteter Position oder beobachteten Lagewinkeln.
    .why = Differenzen innerhalb eines Streifens brauchen so viele.
    .do = Mehr Bilder beobachten oder absolute Positionen verwenden.

flight_line-several_instruments = { $line_name }: Die Bilder wurden mit mehreren Instrumenten beobachtet ({ $names }).
    .do = Den Bildern jedes Instruments einen eigenen Streifen geben.
