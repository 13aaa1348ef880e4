model = Kamera { $camera }: Das Modell { $model } passt besser zu den Aufnahmen als { $other } (sigma0 { $sigma0 }).

model-unknown_sensor = Es gibt kein Sensormodell { $name }.
    .do = Eines von diesen verwenden: { LIST($known, most: 40) }.
