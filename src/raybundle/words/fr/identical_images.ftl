identical_images-copies = { $n } photographie(s) copiant une autre ou sans base écartée(s) : { LIST($names, most: 3) }.

identical_images = { $pairs } paires d'images ont les mêmes points image à un demi-pixel près.
