package-sympy_missing = La dérivation d'un modèle de capteur demande le paquet SymPy.
