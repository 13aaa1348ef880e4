control_mirrored = Les coordonnées d'appui de { $name } sont inversées (image miroir).
