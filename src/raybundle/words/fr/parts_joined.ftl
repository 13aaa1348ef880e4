parts_joined = { $parts } parties du bloc ({ $photographs } photographies) n'ont pas de points communs.
