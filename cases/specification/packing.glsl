// For the functions that pack, which are an extension to GLSL 3.30.
#extension GL_ARB_shading_language_packing : enable
