identical_images-copies = { $n } photographie(s) copiant une autre ou sans base écartée(s) : { LIST($names, most: 3) }.
