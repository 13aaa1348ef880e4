nominal_mirrored = Les coordonnées nominales sont inversées (image miroir).
