//! Which dimensions each domain takes: one after the other, alternatives the same.

use super::left_out::{LeftOut, Part};
use super::needs::{Domain, Draw, refused};
use super::{Cause, Emitter, Scene, Stated, barycentric};
use crate::Result;
use crate::catalog::Mapping;

/// Domains as they are laid out.
#[derive(Default)]
pub(super) struct Layout {
    pub(super) domains: Vec<Domain>,
    pub(super) left_out: Vec<LeftOut>,
    /// Where the next one begins.
    next: u32,
    /// The dimensions so far.
    pub(super) end: u32,
}

impl Layout {
    /// Camera, lights, materials and media, in this order.
    pub(super) fn of(scene: &Scene) -> Result<Self> {
        let mut made = Self::default();
        made.camera(scene);
        made.lights(scene)?;
        made.materials(scene)?;
        made.media(scene);
        Ok(made)
    }

    fn push(&mut self, key: String, draw: Draw, cause: &Cause) {
        let first = self.next;
        self.next += draw.dimensions();
        self.end = self.end.max(self.next);
        self.domains.push(Domain {
            key,
            draw,
            first,
            cause: cause.clone(),
        });
    }

    fn map(&mut self, key: &str, stated: Option<&Stated<Mapping>>) {
        if let Some(Stated { value, cause }) = stated {
            self.push(key.to_owned(), Draw::Map(value.clone()), cause);
        }
    }

    fn skip(&mut self, key: &str, reason: String) {
        self.left_out.push(LeftOut {
            part: Part::Domain,
            name: key.to_owned(),
            reason,
        });
    }

    fn camera(&mut self, scene: &Scene) {
        let camera = &scene.camera;
        self.map("camera.filter", camera.filter.as_ref());
        if camera.filter.is_none() {
            self.skip(
                "camera.filter",
                "no filter: samples are at a pixel's centre".into(),
            );
        }
        self.map("camera.lens", camera.lens.as_ref());
        if camera.lens.is_none() {
            self.skip("camera.lens", "no aperture: the camera is a pinhole".into());
        }
        match &camera.shutter {
            Some(Stated { value, cause }) if value[0] < value[1] => {
                self.push("camera.time".into(), Draw::Between(*value), cause);
            }
            Some(Stated { cause, .. }) => {
                self.skip("camera.time", format!("open for an instant ({cause})"));
            }
            None => self.skip("camera.time", "no shutter: nothing moves".into()),
        }
    }

    fn lights(&mut self, scene: &Scene) -> Result<()> {
        let lights = &scene.lights;
        let powers: Vec<f64> = lights.iter().map(|light| light.power).collect();
        if !powers.is_empty() {
            weights(&powers, "lights", "power")?;
        }
        match &lights[..] {
            [] => self.skip("light.choice", "the scene has no light".into()),
            [one] => self.skip("light.choice", format!("one light alone ({})", one.cause)),
            // A choice there is because of the second.
            [_, two, ..] => self.push("light.choice".into(), Draw::Choice(powers), &two.cause),
        }
        let base = self.next;
        for light in lights {
            self.next = base;
            let key = format!("light.{}", light.name);
            match &light.emitter {
                _ if light.power == 0.0 => {
                    self.skip(
                        &key,
                        format!("never chosen: its power is 0 ({})", light.cause),
                    );
                }
                Emitter::Delta(kind) => {
                    self.skip(
                        &key,
                        format!("a {kind} light is not drawn ({})", light.cause),
                    );
                }
                Emitter::Area(mapping) => self.push(key, Draw::Map(mapping.clone()), &light.cause),
                Emitter::Mesh(areas) => {
                    weights(areas, &key, "area")?;
                    let choice = format!("{key}.triangle");
                    match areas.len() {
                        1 => self.skip(&choice, format!("one triangle alone ({})", light.cause)),
                        _ => self.push(choice, Draw::Choice(areas.clone()), &light.cause),
                    }
                    let point = Draw::Map(barycentric()?);
                    self.push(format!("{key}.point"), point, &light.cause);
                }
            }
        }
        self.next = self.end;
        Ok(())
    }

    fn materials(&mut self, scene: &Scene) -> Result<()> {
        let base = self.next;
        for material in &scene.materials {
            self.next = base;
            let key = format!("material.{}", material.name);
            let shares: Vec<f64> = material.lobes.iter().map(|lobe| lobe.weight).collect();
            if !shares.is_empty() {
                weights(&shares, &key, "weight")?;
            }
            let choice = format!("{key}.lobe");
            match &material.lobes[..] {
                [] => self.skip(&choice, format!("it scatters nothing ({})", material.cause)),
                [one] => self.skip(&choice, format!("one lobe alone ({})", one.cause)),
                _ => self.push(choice, Draw::Choice(shares), &material.cause),
            }
            let base = self.next;
            for lobe in &material.lobes {
                self.next = base;
                let key = format!("{key}.{}", lobe.name);
                match &lobe.map {
                    _ if lobe.weight == 0.0 => {
                        self.skip(
                            &key,
                            format!("never chosen: its weight is 0 ({})", lobe.cause),
                        );
                    }
                    Some(mapping) => self.push(key, Draw::Map(mapping.clone()), &lobe.cause),
                    None => {
                        let cause = &lobe.cause;
                        self.skip(&key, format!("smooth: it has one direction ({cause})"));
                    }
                }
            }
        }
        self.next = self.end;
        Ok(())
    }

    fn media(&mut self, scene: &Scene) {
        let base = self.next;
        for medium in &scene.media {
            self.next = base;
            let key = format!("medium.{}", medium.name);
            for (what, stated) in [("distance", &medium.distance), ("phase", &medium.phase)] {
                let key = format!("{key}.{what}");
                self.map(&key, stated.as_ref());
                if stated.is_none() {
                    self.skip(&key, format!("none is stated ({})", medium.cause));
                }
            }
        }
        self.next = self.end;
    }
}

/// Refuses weights that are none, or of which none is above 0.
fn weights(all: &[f64], of: &str, what: &str) -> Result<()> {
    if let Some(wrong) = all.iter().find(|w| !(w.is_finite() && **w >= 0.0)) {
        return Err(refused(
            format!("{of}: {what} {wrong}"),
            "a weight is finite and at least 0",
            "mend it",
        ));
    }
    if all.iter().any(|w| *w > 0.0) {
        return Ok(());
    }
    Err(refused(
        format!("{of}: each {what} is 0"),
        "something must be drawn",
        "drop what does not count, or give one more than 0",
    ))
}
