camera_constant_unknown = La caméra { $name } n'est pas étalonnée : { $symbol } n'est connu qu'à { PERCENT($share) } % (limite { PERCENT($limit) } %).
