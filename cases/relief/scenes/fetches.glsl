// How often a scene's heights are asked for. Every scene counts; a case that wants to know writes
//
//   call = "counted(search(...).t, fetches)"      with   out = { fetches = "int" }
//
// or, in a law, float(fetches_of(search(...).t)) <= 25.0. An argument is evaluated before the
// function begins, so the count is that of the call between the brackets; both start it anew.
#ifndef ETALON_SCENE_FETCHES
#define ETALON_SCENE_FETCHES

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

int fetch_count = 0;

void count_fetch()
{
    fetch_count += 1;
}

int fetches_of(float result)
{
    int fetches = fetch_count;
    fetch_count = 0;
    return fetches;
}

float counted(float result, out int fetches)
{
    fetches = fetches_of(result);
    return result;
}

#endif
