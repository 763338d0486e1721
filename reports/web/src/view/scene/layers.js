import { createSectionActors } from '../section/section_actor.js';
import { createSurfaceActor } from '../surface/surface_actor.js';

/** What is drawn of the part: the surface with its map, and the cut of a section plane. */
export function createLayers(scene) {
  const surface = createSurfaceActor();
  const section = createSectionActors();
  surface.actors.forEach(scene.add);
  surface.setCoarse(false);
  scene.beforeFrame(({ moving, slow }) => {
    surface.setCoarse(moving && slow);
    surface.look.pixelRatio = scene.pixelRatio();
  });
  section.actors.forEach(scene.add);
  const follow = () => {
    const { dark, ink, background } = scene.theme();
    surface.look.border = dark ? [0.06, 0.07, 0.09] : ink;
    surface.look.back = background.map((c, k) => c + (ink[k] - c) * (dark ? 0.35 : 0.3));
    section.setInk(dark ? [1, 1, 1] : ink);
  };
  follow();
  scene.onTheme(follow);
  return { surface, section };
}
