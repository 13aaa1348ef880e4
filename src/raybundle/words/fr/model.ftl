model = Caméra { $camera } : le modèle { $model } convient mieux aux photographies que { $other } (sigma0 { $sigma0 }).

model-unknown_sensor = Il n'y a pas de modèle de capteur { $name }.
