model = Kamera { $camera }: Das Modell { $model } passt besser zu den Aufnahmen als { $other } (sigma0 { $sigma0 }).
