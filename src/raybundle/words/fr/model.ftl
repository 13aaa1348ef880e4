model = Caméra { $camera } : le modèle { $model } convient mieux aux photographies que { $other } (sigma0 { $sigma0 }).
