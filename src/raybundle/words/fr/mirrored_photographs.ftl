mirrored_photographs = { $n } photographies sont inversées par rapport aux autres et laissées de côté : { LIST($names, most: 3) }.

mirrored_photographs-possible = { $n } photographies sont peut-être inversées par rapport aux autres : { LIST($names, most: 3) }.

mirrored_photographs-stored = { $n } photographies sont enregistrées inversées selon l'orientation EXIF : { LIST($names, most: 3) }.
