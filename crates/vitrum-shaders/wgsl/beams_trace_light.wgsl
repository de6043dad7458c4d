struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_12 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_13 {
member: u32,
member_1: u32,
}
struct type_15 {
member: array<f32>,
}
struct type_19 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: vec3<f32>,
member_13: vec3<f32>,
member_14: i32,
member_15: i32,
member_16: i32,
member_17: f32,
}
struct type_20 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_21 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
member_14: f32,
member_15: f32,
member_16: f32,
}
struct type_22 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_23 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_24 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_25 {
member: type_2,
member_1: type_13,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_20,
member_12: type_21,
member_13: type_22,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_23,
member_19: type_24,
}
struct type_26 {
member: type_25,
}
struct type_27 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: vec3<f32>,
member_6: vec3<f32>,
member_7: i32,
member_8: i32,
member_9: i32,
member_10: f32,
member_11: i32,
member_12: i32,
member_13: f32,
member_14: f32,
member_15: f32,
member_16: i32,
member_17: i32,
member_18: i32,
member_19: i32,
member_20: i32,
member_21: i32,
member_22: i32,
member_23: f32,
member_24: f32,
member_25: f32,
member_26: f32,
member_27: f32,
}
struct type_28 {
member: i32,
member_1: i32,
member_2: f32,
member_3: f32,
member_4: f32,
}
struct type_31 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(1)
var<storage> global_1: type_15;
@group(0) @binding(2)
var<storage> global_2: type_15;
@group(0) @binding(3)
var<storage> global_3: type_15;
@group(0) @binding(4)
var<storage, read_write> global_4: type_15;
@group(0) @binding(0)
var<storage> global_5: type_26;
@group(0) @binding(5)
var<storage, read_write> global_6: type_31;
fn function_() {
var local: f32;
var local_1: i32;
var local_2: f32;
var local_3: i32;
var local_4: f32;
var local_5: i32;
var local_6: f32;
var local_7: i32;
var local_8: f32;
var local_9: i32;
var local_10: f32;
var local_11: i32;
var local_12: f32;
var local_13: i32;
var local_14: f32;
var local_15: i32;
var phi_1793_: f32;
var phi_2213_: u32;
var phi_2216_: f32;
var phi_2357_: i32;
var phi_2370_: i32;
var phi_2384_: i32;
var phi_2706_: i32;
var phi_2719_: i32;
var phi_2733_: i32;
var phi_2214_: u32;
var phi_2217_: f32;
var phi_2938_: f32;
var phi_3166_: f32;
var phi_3193_: type_27;
var phi_3194_: type_27;
var phi_3214_: type_27;
var phi_3216_: type_27;
var phi_3219_: i32;
var phi_3221_: bool;
var phi_4562_: i32;
var phi_4565_: i32;
var phi_4563_: i32;
var phi_4566_: i32;
var local_16: i32;
var phi_4684_: i32;
var phi_4687_: i32;
var phi_4685_: i32;
var phi_4688_: i32;
var local_17: i32;
var phi_6110_: f32;
var phi_4866_: u32;
var phi_4869_: f32;
var phi_5010_: i32;
var phi_5023_: i32;
var phi_5037_: i32;
var phi_5359_: i32;
var phi_5372_: i32;
var phi_5386_: i32;
var phi_4867_: u32;
var phi_4870_: f32;
var phi_5591_: f32;
var phi_5824_: f32;
var phi_6114_: type_27;
var local_18: i32;
var local_19: i32;
var local_20: i32;
var local_21: i32;
var local_22: i32;
var phi_8843_: f32;
var phi_8844_: f32;
var phi_9077_: f32;
var local_23: i32;
var local_24: i32;
var local_25: i32;
var phi_9881_: type_27;
var phi_9891_: type_27;
var phi_9892_: type_27;
var phi_9912_: type_27;
var phi_10067_: vec3<f32>;
var phi_10193_: vec3<f32>;
var phi_10211_: type_27;
var phi_9208_: f32;
var phi_10212_: type_27;
var phi_10367_: f32;
var phi_10411_: type_27;
var phi_10995_: f32;
var phi_11430_: u32;
var phi_11433_: f32;
var phi_11574_: i32;
var phi_11587_: i32;
var phi_11601_: i32;
var phi_11923_: i32;
var phi_11936_: i32;
var phi_11950_: i32;
var phi_11431_: u32;
var phi_11434_: f32;
var phi_12155_: f32;
var phi_12383_: f32;
var phi_12410_: type_27;
var phi_12411_: type_27;
var phi_12412_: type_27;
var phi_12413_: type_27;
var phi_12414_: type_27;
var phi_6168_: f32;
var phi_6180_: type_27;
var phi_6221_: type_27;
var phi_6805_: f32;
var phi_7240_: u32;
var phi_7243_: f32;
var phi_7384_: i32;
var phi_7397_: i32;
var phi_7411_: i32;
var phi_7733_: i32;
var phi_7746_: i32;
var phi_7760_: i32;
var phi_7241_: u32;
var phi_7244_: f32;
var phi_7965_: f32;
var phi_8193_: f32;
var phi_8220_: type_27;
var phi_8221_: type_27;
var phi_12415_: type_27;
var phi_12416_: type_27;
var phi_12417_: bool;
var phi_12421_: type_27;
var phi_12422_: type_27;
var phi_3447_: f32;
var phi_3760_: i32;
var phi_4371_: i32;
var phi_4521_: type_28;
var phi_4515_: bool;
var phi_4516_: bool;
var phi_4522_: type_28;
var phi_4523_: bool;
var phi_4530_: type_19;
var phi_4531_: type_28;
var phi_4532_: type_19;
var phi_4534_: type_28;
var phi_4535_: type_19;
var phi_4536_: bool;
var phi_4540_: type_28;
var phi_4541_: type_19;
var phi_4542_: bool;
var phi_4546_: type_28;
var phi_4547_: type_19;
var phi_12424_: type_27;
var phi_12425_: bool;
var phi_3217_: type_27;
var phi_3220_: i32;
var phi_3222_: bool;
var local_26: type_27;
var local_27: type_27;
var local_28: type_27;
var local_29: type_27;
var local_30: type_27;
var local_31: type_27;
var local_32: type_27;
var local_33: type_27;
var local_34: type_27;
var local_35: type_27;
var local_36: type_27;
var local_37: type_27;
var local_38: type_27;
var local_39: type_27;
var local_40: type_27;
var local_41: type_27;
var local_42: type_27;
var local_43: type_27;
var local_44: type_27;
var local_45: type_27;
var local_46: type_27;
var local_47: type_27;
var local_48: type_27;
var local_49: type_27;
var local_50: type_27;
var local_51: type_27;
var local_52: type_27;
var local_53: type_27;
var local_54: type_27;
var local_55: type_27;
var local_56: type_27;
var local_57: type_27;
var local_58: type_27;
var local_59: type_27;
var local_60: type_27;
var local_61: type_27;
var local_62: type_27;
var local_63: type_27;
var local_64: type_27;
var local_65: type_27;
var local_66: type_27;
var local_67: f32;
var local_68: f32;
var local_69: f32;
var local_70: f32;
var local_71: f32;
let _e139 = global;
let _e141 = arrayLength((&global_1.member));
let _e143 = arrayLength((&global_2.member));
let _e146 = arrayLength((&global_3.member));
let _e153 = global_5.member.member;
if (_e139.x < _e153.member) {
if (_e139.y < _e153.member_1) {
let _e160 = (_e153.member * _e153.member_1);
let _e162 = ((_e139.y * _e153.member) + _e139.x);
let _e163 = bitcast<i32>(_e162);
let _e165 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e167 = select(_e165, _e163, (_e163 < _e165));
let _e173 = global_4.member[bitcast<u32>(select(0i, _e167, (_e167 > 0i)))];
let _e174 = (_e160 + _e162);
let _e175 = bitcast<i32>(_e174);
let _e177 = select(_e165, _e175, (_e175 < _e165));
let _e183 = global_4.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e185 = ((2u * _e160) + _e162);
let _e186 = bitcast<i32>(_e185);
let _e188 = select(_e165, _e186, (_e186 < _e165));
let _e194 = global_4.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e196 = ((3u * _e160) + _e162);
let _e197 = bitcast<i32>(_e196);
let _e199 = select(_e165, _e197, (_e197 < _e165));
let _e205 = global_4.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e207 = ((4u * _e160) + _e162);
let _e208 = bitcast<i32>(_e207);
let _e210 = select(_e165, _e208, (_e208 < _e165));
let _e216 = global_4.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e218 = ((5u * _e160) + _e162);
let _e219 = bitcast<i32>(_e218);
let _e221 = select(_e165, _e219, (_e219 < _e165));
let _e227 = global_4.member[bitcast<u32>(select(0i, _e221, (_e221 > 0i)))];
let _e229 = ((6u * _e160) + _e162);
let _e230 = bitcast<i32>(_e229);
let _e232 = select(_e165, _e230, (_e230 < _e165));
let _e238 = global_4.member[bitcast<u32>(select(0i, _e232, (_e232 > 0i)))];
let _e240 = ((7u * _e160) + _e162);
let _e241 = bitcast<i32>(_e240);
let _e243 = select(_e165, _e241, (_e241 < _e165));
let _e249 = global_4.member[bitcast<u32>(select(0i, _e243, (_e243 > 0i)))];
let _e251 = ((8u * _e160) + _e162);
let _e252 = bitcast<i32>(_e251);
let _e254 = select(_e165, _e252, (_e252 < _e165));
let _e260 = global_4.member[bitcast<u32>(select(0i, _e254, (_e254 > 0i)))];
let _e262 = ((9u * _e160) + _e162);
let _e263 = bitcast<i32>(_e262);
let _e265 = select(_e165, _e263, (_e263 < _e165));
let _e271 = global_4.member[bitcast<u32>(select(0i, _e265, (_e265 > 0i)))];
let _e273 = ((10u * _e160) + _e162);
let _e274 = bitcast<i32>(_e273);
let _e276 = select(_e165, _e274, (_e274 < _e165));
let _e282 = global_4.member[bitcast<u32>(select(0i, _e276, (_e276 > 0i)))];
let _e284 = ((11u * _e160) + _e162);
let _e285 = bitcast<i32>(_e284);
let _e287 = select(_e165, _e285, (_e285 < _e165));
let _e293 = global_4.member[bitcast<u32>(select(0i, _e287, (_e287 > 0i)))];
let _e295 = ((12u * _e160) + _e162);
let _e296 = bitcast<i32>(_e295);
let _e298 = select(_e165, _e296, (_e296 < _e165));
let _e304 = global_4.member[bitcast<u32>(select(0i, _e298, (_e298 > 0i)))];
let _e306 = ((13u * _e160) + _e162);
let _e307 = bitcast<i32>(_e306);
let _e309 = select(_e165, _e307, (_e307 < _e165));
let _e315 = global_4.member[bitcast<u32>(select(0i, _e309, (_e309 > 0i)))];
let _e317 = ((14u * _e160) + _e162);
let _e318 = bitcast<i32>(_e317);
let _e320 = select(_e165, _e318, (_e318 < _e165));
let _e326 = global_4.member[bitcast<u32>(select(0i, _e320, (_e320 > 0i)))];
let _e328 = ((15u * _e160) + _e162);
let _e329 = bitcast<i32>(_e328);
let _e331 = select(_e165, _e329, (_e329 < _e165));
let _e337 = global_4.member[bitcast<u32>(select(0i, _e331, (_e331 > 0i)))];
let _e339 = ((16u * _e160) + _e162);
let _e340 = bitcast<i32>(_e339);
let _e342 = select(_e165, _e340, (_e340 < _e165));
let _e348 = global_4.member[bitcast<u32>(select(0i, _e342, (_e342 > 0i)))];
let _e350 = ((17u * _e160) + _e162);
let _e351 = bitcast<i32>(_e350);
let _e353 = select(_e165, _e351, (_e351 < _e165));
let _e359 = global_4.member[bitcast<u32>(select(0i, _e353, (_e353 > 0i)))];
let _e361 = ((18u * _e160) + _e162);
let _e362 = bitcast<i32>(_e361);
let _e364 = select(_e165, _e362, (_e362 < _e165));
let _e370 = global_4.member[bitcast<u32>(select(0i, _e364, (_e364 > 0i)))];
let _e372 = ((19u * _e160) + _e162);
let _e373 = bitcast<i32>(_e372);
let _e375 = select(_e165, _e373, (_e373 < _e165));
let _e381 = global_4.member[bitcast<u32>(select(0i, _e375, (_e375 > 0i)))];
let _e383 = ((20u * _e160) + _e162);
let _e384 = bitcast<i32>(_e383);
let _e386 = select(_e165, _e384, (_e384 < _e165));
let _e392 = global_4.member[bitcast<u32>(select(0i, _e386, (_e386 > 0i)))];
let _e394 = ((21u * _e160) + _e162);
let _e395 = bitcast<i32>(_e394);
let _e397 = select(_e165, _e395, (_e395 < _e165));
let _e403 = global_4.member[bitcast<u32>(select(0i, _e397, (_e397 > 0i)))];
let _e405 = ((22u * _e160) + _e162);
let _e406 = bitcast<i32>(_e405);
let _e408 = select(_e165, _e406, (_e406 < _e165));
let _e414 = global_4.member[bitcast<u32>(select(0i, _e408, (_e408 > 0i)))];
let _e416 = ((23u * _e160) + _e162);
let _e417 = bitcast<i32>(_e416);
let _e419 = select(_e165, _e417, (_e417 < _e165));
let _e425 = global_4.member[bitcast<u32>(select(0i, _e419, (_e419 > 0i)))];
let _e427 = ((24u * _e160) + _e162);
let _e428 = bitcast<i32>(_e427);
let _e430 = select(_e165, _e428, (_e428 < _e165));
let _e436 = global_4.member[bitcast<u32>(select(0i, _e430, (_e430 > 0i)))];
let _e438 = ((25u * _e160) + _e162);
let _e439 = bitcast<i32>(_e438);
let _e441 = select(_e165, _e439, (_e439 < _e165));
let _e447 = global_4.member[bitcast<u32>(select(0i, _e441, (_e441 > 0i)))];
let _e449 = ((26u * _e160) + _e162);
let _e450 = bitcast<i32>(_e449);
let _e452 = select(_e165, _e450, (_e450 < _e165));
let _e458 = global_4.member[bitcast<u32>(select(0i, _e452, (_e452 > 0i)))];
let _e460 = ((27u * _e160) + _e162);
let _e461 = bitcast<i32>(_e460);
let _e463 = select(_e165, _e461, (_e461 < _e165));
let _e469 = global_4.member[bitcast<u32>(select(0i, _e463, (_e463 > 0i)))];
let _e471 = ((28u * _e160) + _e162);
let _e472 = bitcast<i32>(_e471);
let _e474 = select(_e165, _e472, (_e472 < _e165));
let _e480 = global_4.member[bitcast<u32>(select(0i, _e474, (_e474 > 0i)))];
let _e482 = ((29u * _e160) + _e162);
let _e483 = bitcast<i32>(_e482);
let _e485 = select(_e165, _e483, (_e483 < _e165));
let _e491 = global_4.member[bitcast<u32>(select(0i, _e485, (_e485 > 0i)))];
let _e493 = ((30u * _e160) + _e162);
let _e494 = bitcast<i32>(_e493);
let _e496 = select(_e165, _e494, (_e494 < _e165));
let _e502 = global_4.member[bitcast<u32>(select(0i, _e496, (_e496 > 0i)))];
let _e504 = ((31u * _e160) + _e162);
let _e505 = bitcast<i32>(_e504);
let _e507 = select(_e165, _e505, (_e505 < _e165));
let _e513 = global_4.member[bitcast<u32>(select(0i, _e507, (_e507 > 0i)))];
let _e515 = ((32u * _e160) + _e162);
let _e516 = bitcast<i32>(_e515);
let _e518 = select(_e165, _e516, (_e516 < _e165));
let _e524 = global_4.member[bitcast<u32>(select(0i, _e518, (_e518 > 0i)))];
let _e526 = ((33u * _e160) + _e162);
let _e527 = bitcast<i32>(_e526);
let _e529 = select(_e165, _e527, (_e527 < _e165));
let _e535 = global_4.member[bitcast<u32>(select(0i, _e529, (_e529 > 0i)))];
let _e537 = ((34u * _e160) + _e162);
let _e538 = bitcast<i32>(_e537);
let _e540 = select(_e165, _e538, (_e538 < _e165));
let _e546 = global_4.member[bitcast<u32>(select(0i, _e540, (_e540 > 0i)))];
let _e548 = ((35u * _e160) + _e162);
let _e549 = bitcast<i32>(_e548);
let _e551 = select(_e165, _e549, (_e549 < _e165));
let _e557 = global_4.member[bitcast<u32>(select(0i, _e551, (_e551 > 0i)))];
let _e559 = ((36u * _e160) + _e162);
let _e560 = bitcast<i32>(_e559);
let _e562 = select(_e165, _e560, (_e560 < _e165));
let _e568 = global_4.member[bitcast<u32>(select(0i, _e562, (_e562 > 0i)))];
let _e570 = ((37u * _e160) + _e162);
let _e571 = bitcast<i32>(_e570);
let _e573 = select(_e165, _e571, (_e571 < _e165));
let _e579 = global_4.member[bitcast<u32>(select(0i, _e573, (_e573 > 0i)))];
let _e581 = ((38u * _e160) + _e162);
let _e582 = bitcast<i32>(_e581);
let _e584 = select(_e165, _e582, (_e582 < _e165));
let _e590 = global_4.member[bitcast<u32>(select(0i, _e584, (_e584 > 0i)))];
let _e592 = ((39u * _e160) + _e162);
let _e593 = bitcast<i32>(_e592);
let _e595 = select(_e165, _e593, (_e593 < _e165));
let _e601 = global_4.member[bitcast<u32>(select(0i, _e595, (_e595 > 0i)))];
let _e603 = ((40u * _e160) + _e162);
let _e604 = bitcast<i32>(_e603);
let _e606 = select(_e165, _e604, (_e604 < _e165));
let _e612 = global_4.member[bitcast<u32>(select(0i, _e606, (_e606 > 0i)))];
let _e614 = ((41u * _e160) + _e162);
let _e615 = bitcast<i32>(_e614);
let _e617 = select(_e165, _e615, (_e615 < _e165));
let _e623 = global_4.member[bitcast<u32>(select(0i, _e617, (_e617 > 0i)))];
let _e630 = select(0i, select(select(i32(_e568), i32(-2147483648), (_e568 < -2147483600f)), 2147483647i, (_e568 > 2147483500f)), (_e568 == _e568));
let _e635 = global_5.member.member_12.member_4;
let _e641 = select(3u, 0u, ((_e491 == 3f) || ((_e491 == 2f) && (_e630 > bitcast<i32>(_e635)))));
if (_e641 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e650 = atomicLoad((&global_6.member[0u]));
if (_e650 == 0u) {
atomicStore((&global_6.member[0u]), ((_e153.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e153.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e641 > 1u) {
let _e712 = select(0i, select(select(i32(_e513), i32(-2147483648), (_e513 < -2147483600f)), 2147483647i, (_e513 > 2147483500f)), (_e513 == _e513));
let _e719 = select(0i, select(select(i32(_e524), i32(-2147483648), (_e524 < -2147483600f)), 2147483647i, (_e524 > 2147483500f)), (_e524 == _e524));
let _e726 = select(0i, select(select(i32(_e535), i32(-2147483648), (_e535 < -2147483600f)), 2147483647i, (_e535 > 2147483500f)), (_e535 == _e535));
let _e733 = select(0i, select(select(i32(_e546), i32(-2147483648), (_e546 < -2147483600f)), 2147483647i, (_e546 > 2147483500f)), (_e546 == _e546));
let _e740 = select(0i, select(select(i32(_e557), i32(-2147483648), (_e557 < -2147483600f)), 2147483647i, (_e557 > 2147483500f)), (_e557 == _e557));
if (_e491 == 0f) {
let _e748 = global_5.member.member_11.member_2;
let _e755 = global_5.member.member_11.member_3;
let _e762 = global_5.member.member_11.member_5;
let _e768 = global_5.member.member_11.member_7;
let _e770 = (_e762 + ((f32(bitcast<i32>(_e139.x)) + 0.5f) * _e768));
let _e774 = global_5.member.member_11.member_6;
let _e780 = global_5.member.member_11.member_8;
let _e782 = (_e774 + ((f32(bitcast<i32>(_e139.y)) + 0.5f) * _e780));
let _e783 = (_e748.member * _e768);
let _e784 = (_e748.member_1 * _e768);
let _e785 = (_e748.member_2 * _e768);
let _e786 = (_e755.member * _e780);
let _e787 = (_e755.member_1 * _e780);
let _e788 = (_e755.member_2 * _e780);
let _e795 = ((_e748.member * _e770) + (_e755.member * _e782));
let _e796 = ((_e748.member_1 * _e770) + (_e755.member_1 * _e782));
let _e797 = ((_e748.member_2 * _e770) + (_e755.member_2 * _e782));
let _e801 = global_5.member.member_11.member_4;
let _e808 = global_5.member.member_11.member_1;
let _e815 = global_5.member.member_10.member;
let _e816 = (_e815 == 0u);
let _e817 = (_e808.member + _e795);
let _e818 = (_e808.member_1 + _e796);
let _e819 = (_e808.member_2 + _e797);
let _e824 = (((_e817 * _e817) + (_e818 * _e818)) + (_e819 * _e819));
let _e828 = (1f / sqrt(select(0f, _e824, (_e824 > 0f))));
let _e832 = select((_e817 * _e828), _e808.member, _e816);
let _e833 = select((_e818 * _e828), _e808.member_1, _e816);
let _e834 = select((_e819 * _e828), _e808.member_2, _e816);
let _e839 = select(_e801.member, (_e801.member + _e795), _e816);
let _e840 = select(_e801.member_1, (_e801.member_1 + _e796), _e816);
let _e841 = select(_e801.member_2, (_e801.member_2 + _e797), _e816);
let _e855 = (((_e783 * _e832) + (_e784 * _e833)) + (_e785 * _e834));
let _e865 = select(((_e783 - (_e832 * _e855)) * _e828), 0f, _e816);
let _e866 = select(((_e784 - (_e833 * _e855)) * _e828), 0f, _e816);
let _e867 = select(((_e785 - (_e834 * _e855)) * _e828), 0f, _e816);
let _e873 = (((_e786 * _e832) + (_e787 * _e833)) + (_e788 * _e834));
let _e883 = select(((_e786 - (_e832 * _e873)) * _e828), 0f, _e816);
let _e884 = select(((_e787 - (_e833 * _e873)) * _e828), 0f, _e816);
let _e885 = select(((_e788 - (_e834 * _e873)) * _e828), 0f, _e816);
let _e894 = (1f / select(_e832, select(1e-12f, -1e-12f, (_e832 < 0f)), (bitcast<f32>((bitcast<u32>(_e832) & 2147483647u)) < 1e-12f)));
let _e902 = (1f / select(_e833, select(1e-12f, -1e-12f, (_e833 < 0f)), (bitcast<f32>((bitcast<u32>(_e833) & 2147483647u)) < 1e-12f)));
let _e910 = (1f / select(_e834, select(1e-12f, -1e-12f, (_e834 < 0f)), (bitcast<f32>((bitcast<u32>(_e834) & 2147483647u)) < 1e-12f)));
let _e913 = global_5.member.member_8;
let _e919 = global_5.member.member_9;
let _e924 = ((_e913.member - _e839) * _e894);
let _e926 = ((_e919.member - _e839) * _e894);
let _e928 = ((_e913.member_1 - _e840) * _e902);
let _e930 = ((_e919.member_1 - _e840) * _e902);
let _e932 = ((_e913.member_2 - _e841) * _e910);
let _e934 = ((_e919.member_2 - _e841) * _e910);
let _e936 = select(_e926, _e924, (_e924 < _e926));
let _e938 = select(_e930, _e928, (_e928 < _e930));
let _e940 = select(_e938, _e936, (_e936 > _e938));
let _e942 = select(_e934, _e932, (_e932 < _e934));
let _e944 = select(_e942, _e940, (_e940 > _e942));
let _e946 = select(_e926, _e924, (_e924 > _e926));
let _e948 = select(_e930, _e928, (_e928 > _e930));
let _e950 = select(_e948, _e946, (_e946 < _e948));
let _e952 = select(_e934, _e932, (_e932 > _e934));
if (true && _e816) {
phi_1793_ = -(1e30f);
} else {
phi_1793_ = 0f;
}
let _e958 = phi_1793_;
let _e960 = select(_e958, _e944, (_e944 > _e958));
let _e962 = ((select(_e952, _e950, (_e950 < _e952)) <= _e960) || false);
let _e963 = select(_e960, 0f, _e962);
let _e964 = (_e832 * _e963);
let _e965 = (_e833 * _e963);
let _e966 = (_e834 * _e963);
let _e967 = (_e839 + _e964);
let _e968 = (_e840 + _e965);
let _e969 = (_e841 + _e966);
let _e986 = global_5.member.member_14.member.member;
let _e997 = ((((_e986.member.member * _e967) + (_e986.member.member_1 * _e968)) + (_e986.member.member_2 * _e969)) + _e986.member_1);
let _e1003 = -((((_e986.member.member * _e832) + (_e986.member.member_1 * _e833)) + (_e986.member.member_2 * _e834)));
let _e1005 = (_e1003 > 1e-9f);
let _e1009 = ((_e997 / select(1e-9f, _e1003, _e1005)) - 0.015625f);
let _e1012 = select(1e30f, select(0f, _e1009, (_e1009 > 0f)), ((_e997 > 0f) && _e1005));
let _e1017 = global_5.member.member_14.member_1.member;
let _e1028 = ((((_e1017.member.member * _e967) + (_e1017.member.member_1 * _e968)) + (_e1017.member.member_2 * _e969)) + _e1017.member_1);
let _e1034 = -((((_e1017.member.member * _e832) + (_e1017.member.member_1 * _e833)) + (_e1017.member.member_2 * _e834)));
let _e1036 = (_e1034 > 1e-9f);
let _e1040 = ((_e1028 / select(1e-9f, _e1034, _e1036)) - 0.015625f);
let _e1043 = select(1e30f, select(0f, _e1040, (_e1040 > 0f)), ((_e1028 > 0f) && _e1036));
let _e1047 = (_e1043 < _e1012);
let _e1051 = type_27((vec3<f32>(_e839, _e840, _e841) + vec3<f32>(_e964, _e965, _e966)), vec3<f32>(_e832, _e833, _e834), (vec3<f32>(select(0f, _e783, _e816), select(0f, _e784, _e816), select(0f, _e785, _e816)) + vec3<f32>((_e865 * _e963), (_e866 * _e963), (_e867 * _e963))), (vec3<f32>(select(0f, _e786, _e816), select(0f, _e787, _e816), select(0f, _e788, _e816)) + vec3<f32>((_e883 * _e963), (_e884 * _e963), (_e885 * _e963))), vec3<f32>(_e865, _e866, _e867), vec3<f32>(_e883, _e884, _e885), vec3<f32>(1f, 1f, 1f), 0i, 0i, select(select(-2i, -3i, _e1047), -1i, ((_e1012 >= 1e30f) && (_e1043 >= 1e30f))), select(_e1012, _e1043, _e1047), 0i, 0i, 0f, _e480, 1f, 0i, _e712, _e719, _e726, _e733, _e740, _e630, _e579, _e590, _e601, _e612, _e623);
let _e1055 = global_5.member.member_13.member_4;
let _e1062 = global_5.member.member_13.member_5;
let _e1067 = ((_e1055.member - _e839) * _e894);
let _e1069 = ((_e1062.member - _e839) * _e894);
let _e1071 = ((_e1055.member_1 - _e840) * _e902);
let _e1073 = ((_e1062.member_1 - _e840) * _e902);
let _e1075 = ((_e1055.member_2 - _e841) * _e910);
let _e1077 = ((_e1062.member_2 - _e841) * _e910);
let _e1079 = select(_e1069, _e1067, (_e1067 < _e1069));
let _e1081 = select(_e1073, _e1071, (_e1071 < _e1073));
let _e1083 = select(_e1081, _e1079, (_e1079 > _e1081));
let _e1085 = select(_e1077, _e1075, (_e1075 < _e1077));
let _e1087 = select(_e1085, _e1083, (_e1083 > _e1085));
let _e1089 = select(_e1069, _e1067, (_e1067 > _e1069));
let _e1091 = select(_e1073, _e1071, (_e1071 > _e1073));
let _e1093 = select(_e1091, _e1089, (_e1089 < _e1091));
let _e1095 = select(_e1077, _e1075, (_e1075 > _e1077));
let _e1097 = select(_e1095, _e1093, (_e1093 < _e1095));
let _e1099 = select(_e958, _e1087, (_e1087 > _e958));
let _e1101 = select(_e963, _e1097, (_e1097 < _e963));
let _e1102 = (_e1101 > _e1099);
let _e1103 = select(_e958, _e1099, _e1102);
let _e1105 = (select(_e958, _e1101, _e1102) - _e1103);
let _e1109 = global_5.member.member_13.member_6;
if (_e1109 == 0u) {
phi_2938_ = _e1105;
} else {
let _e1112 = (_e1105 / f32(_e1109));
phi_2213_ = 0u;
phi_2216_ = 0f;
loop {
let _e1114 = phi_2213_;
let _e1116 = phi_2216_;
local_68 = _e1116;
let _e1119 = ((_e1114 < _e1109) && (_e1105 > 0f));
if _e1119 {
let _e1122 = (_e1103 + (_e1112 * f32(_e1114)));
let _e1123 = (_e1122 + _e1112);
let _e1125 = (0.5f * (_e1122 + _e1123));
let _e1126 = (_e1123 - _e1122);
let _e1127 = (0.28867513f * _e1126);
let _e1128 = (_e1125 - _e1127);
let _e1138 = global_5.member.member_13.member_7;
let _e1139 = bitcast<i32>(_e1138);
let _e1143 = global_5.member.member_13.member_8;
let _e1144 = bitcast<i32>(_e1143);
let _e1148 = global_5.member.member_13.member_9;
let _e1149 = bitcast<i32>(_e1148);
let _e1150 = f32(_e1139);
let _e1152 = (_e1062.member - _e1055.member);
let _e1155 = (((((_e839 + (_e832 * _e1128)) - _e1055.member) / _e1152) * _e1150) - 0.5f);
let _e1156 = (_e1150 - 1f);
let _e1158 = select(0f, _e1155, (_e1155 > 0f));
let _e1160 = select(_e1156, _e1158, (_e1158 < _e1156));
let _e1161 = f32(_e1144);
let _e1163 = (_e1062.member_1 - _e1055.member_1);
let _e1166 = (((((_e840 + (_e833 * _e1128)) - _e1055.member_1) / _e1163) * _e1161) - 0.5f);
let _e1167 = (_e1161 - 1f);
let _e1169 = select(0f, _e1166, (_e1166 > 0f));
let _e1171 = select(_e1167, _e1169, (_e1169 < _e1167));
let _e1172 = f32(_e1149);
let _e1174 = (_e1062.member_2 - _e1055.member_2);
let _e1177 = (((((_e841 + (_e834 * _e1128)) - _e1055.member_2) / _e1174) * _e1172) - 0.5f);
let _e1178 = (_e1172 - 1f);
let _e1180 = select(0f, _e1177, (_e1177 > 0f));
let _e1182 = select(_e1178, _e1180, (_e1180 < _e1178));
let _e1184 = select(0f, _e1160, (_e1160 > 0f));
let _e1186 = select(1e6f, _e1184, (_e1184 < 1e6f));
let _e1193 = select(0i, select(select(i32(_e1186), i32(-2147483648), (_e1186 < -2147483600f)), 2147483647i, (_e1186 > 2147483500f)), (_e1186 == _e1186));
let _e1197 = (_e1193 - select(0i, 1i, (_e1186 < f32(_e1193))));
let _e1199 = select(0f, _e1171, (_e1171 > 0f));
let _e1201 = select(1e6f, _e1199, (_e1199 < 1e6f));
let _e1208 = select(0i, select(select(i32(_e1201), i32(-2147483648), (_e1201 < -2147483600f)), 2147483647i, (_e1201 > 2147483500f)), (_e1201 == _e1201));
let _e1212 = (_e1208 - select(0i, 1i, (_e1201 < f32(_e1208))));
let _e1214 = select(0f, _e1182, (_e1182 > 0f));
let _e1216 = select(1e6f, _e1214, (_e1214 < 1e6f));
let _e1223 = select(0i, select(select(i32(_e1216), i32(-2147483648), (_e1216 < -2147483600f)), 2147483647i, (_e1216 > 2147483500f)), (_e1216 == _e1216));
let _e1227 = (_e1223 - select(0i, 1i, (_e1216 < f32(_e1223))));
let _e1231 = (_e1171 - f32(_e1212));
let _e1233 = (_e1182 - f32(_e1227));
local_14 = (_e1160 - f32(_e1197));
let _e1234 = (_e1197 + 1i);
let _e1236 = select(_e1234, 0i, (_e1234 < 0i));
if (_e1236 >= _e1139) {
phi_2357_ = (_e1139 - 1i);
} else {
phi_2357_ = _e1236;
}
let _e1240 = phi_2357_;
local_15 = (_e1240 - _e1197);
let _e1242 = (_e1212 + 1i);
let _e1244 = select(_e1242, 0i, (_e1242 < 0i));
if (_e1244 >= _e1144) {
phi_2370_ = (_e1144 - 1i);
} else {
phi_2370_ = _e1244;
}
let _e1248 = phi_2370_;
let _e1250 = ((_e1248 - _e1212) * _e1139);
let _e1251 = (_e1227 + 1i);
let _e1253 = select(_e1251, 0i, (_e1251 < 0i));
if (_e1253 >= _e1149) {
phi_2384_ = (_e1149 - 1i);
} else {
phi_2384_ = _e1253;
}
let _e1257 = phi_2384_;
let _e1264 = global_5.member.member_13.member_10;
let _e1265 = bitcast<i32>(_e1264);
let _e1270 = ((_e1265 + (((_e1227 * _e1144) + _e1212) * _e1139)) + _e1197);
let _e1272 = (bitcast<i32>(_e146) - 1i);
let _e1274 = select(_e1272, _e1270, (_e1270 < _e1272));
let _e1279 = global_3.member[bitcast<u32>(select(0i, _e1274, (_e1274 > 0i)))];
let _e1280 = local_14;
let _e1283 = local_15;
let _e1284 = (_e1270 + _e1283);
let _e1286 = select(_e1272, _e1284, (_e1284 < _e1272));
let _e1291 = global_3.member[bitcast<u32>(select(0i, _e1286, (_e1286 > 0i)))];
let _e1292 = local_14;
let _e1295 = (1f - _e1231);
let _e1297 = (_e1270 + _e1250);
let _e1299 = select(_e1272, _e1297, (_e1297 < _e1272));
let _e1304 = global_3.member[bitcast<u32>(select(0i, _e1299, (_e1299 > 0i)))];
let _e1305 = local_14;
let _e1308 = local_15;
let _e1309 = (_e1297 + _e1308);
let _e1311 = select(_e1272, _e1309, (_e1309 < _e1272));
let _e1316 = global_3.member[bitcast<u32>(select(0i, _e1311, (_e1311 > 0i)))];
let _e1317 = local_14;
let _e1322 = (_e1270 + (((_e1257 - _e1227) * _e1139) * _e1144));
let _e1324 = select(_e1272, _e1322, (_e1322 < _e1272));
let _e1329 = global_3.member[bitcast<u32>(select(0i, _e1324, (_e1324 > 0i)))];
let _e1330 = local_14;
let _e1333 = local_15;
let _e1334 = (_e1322 + _e1333);
let _e1336 = select(_e1272, _e1334, (_e1334 < _e1272));
let _e1341 = global_3.member[bitcast<u32>(select(0i, _e1336, (_e1336 > 0i)))];
let _e1342 = local_14;
let _e1346 = (_e1322 + _e1250);
let _e1348 = select(_e1272, _e1346, (_e1346 < _e1272));
let _e1353 = global_3.member[bitcast<u32>(select(0i, _e1348, (_e1348 > 0i)))];
let _e1354 = local_14;
let _e1357 = local_15;
let _e1358 = (_e1346 + _e1357);
let _e1360 = select(_e1272, _e1358, (_e1358 < _e1272));
let _e1365 = global_3.member[bitcast<u32>(select(0i, _e1360, (_e1360 > 0i)))];
let _e1366 = local_14;
let _e1375 = (_e1125 + _e1127);
let _e1385 = (((((_e839 + (_e832 * _e1375)) - _e1055.member) / _e1152) * _e1150) - 0.5f);
let _e1387 = select(0f, _e1385, (_e1385 > 0f));
let _e1389 = select(_e1156, _e1387, (_e1387 < _e1156));
let _e1393 = (((((_e840 + (_e833 * _e1375)) - _e1055.member_1) / _e1163) * _e1161) - 0.5f);
let _e1395 = select(0f, _e1393, (_e1393 > 0f));
let _e1397 = select(_e1167, _e1395, (_e1395 < _e1167));
let _e1401 = (((((_e841 + (_e834 * _e1375)) - _e1055.member_2) / _e1174) * _e1172) - 0.5f);
let _e1403 = select(0f, _e1401, (_e1401 > 0f));
let _e1405 = select(_e1178, _e1403, (_e1403 < _e1178));
let _e1407 = select(0f, _e1389, (_e1389 > 0f));
let _e1409 = select(1e6f, _e1407, (_e1407 < 1e6f));
let _e1416 = select(0i, select(select(i32(_e1409), i32(-2147483648), (_e1409 < -2147483600f)), 2147483647i, (_e1409 > 2147483500f)), (_e1409 == _e1409));
let _e1420 = (_e1416 - select(0i, 1i, (_e1409 < f32(_e1416))));
let _e1422 = select(0f, _e1397, (_e1397 > 0f));
let _e1424 = select(1e6f, _e1422, (_e1422 < 1e6f));
let _e1431 = select(0i, select(select(i32(_e1424), i32(-2147483648), (_e1424 < -2147483600f)), 2147483647i, (_e1424 > 2147483500f)), (_e1424 == _e1424));
let _e1435 = (_e1431 - select(0i, 1i, (_e1424 < f32(_e1431))));
let _e1437 = select(0f, _e1405, (_e1405 > 0f));
let _e1439 = select(1e6f, _e1437, (_e1437 < 1e6f));
let _e1446 = select(0i, select(select(i32(_e1439), i32(-2147483648), (_e1439 < -2147483600f)), 2147483647i, (_e1439 > 2147483500f)), (_e1439 == _e1439));
let _e1450 = (_e1446 - select(0i, 1i, (_e1439 < f32(_e1446))));
let _e1454 = (_e1397 - f32(_e1435));
let _e1456 = (_e1405 - f32(_e1450));
local_12 = (_e1389 - f32(_e1420));
let _e1457 = (_e1420 + 1i);
let _e1459 = select(_e1457, 0i, (_e1457 < 0i));
if (_e1459 >= _e1139) {
phi_2706_ = (_e1139 - 1i);
} else {
phi_2706_ = _e1459;
}
let _e1463 = phi_2706_;
local_13 = (_e1463 - _e1420);
let _e1465 = (_e1435 + 1i);
let _e1467 = select(_e1465, 0i, (_e1465 < 0i));
if (_e1467 >= _e1144) {
phi_2719_ = (_e1144 - 1i);
} else {
phi_2719_ = _e1467;
}
let _e1471 = phi_2719_;
let _e1473 = ((_e1471 - _e1435) * _e1139);
let _e1474 = (_e1450 + 1i);
let _e1476 = select(_e1474, 0i, (_e1474 < 0i));
if (_e1476 >= _e1149) {
phi_2733_ = (_e1149 - 1i);
} else {
phi_2733_ = _e1476;
}
let _e1480 = phi_2733_;
let _e1488 = ((_e1265 + (((_e1450 * _e1144) + _e1435) * _e1139)) + _e1420);
let _e1490 = select(_e1272, _e1488, (_e1488 < _e1272));
let _e1495 = global_3.member[bitcast<u32>(select(0i, _e1490, (_e1490 > 0i)))];
let _e1496 = local_12;
let _e1499 = local_13;
let _e1500 = (_e1488 + _e1499);
let _e1502 = select(_e1272, _e1500, (_e1500 < _e1272));
let _e1507 = global_3.member[bitcast<u32>(select(0i, _e1502, (_e1502 > 0i)))];
let _e1508 = local_12;
let _e1511 = (1f - _e1454);
let _e1513 = (_e1488 + _e1473);
let _e1515 = select(_e1272, _e1513, (_e1513 < _e1272));
let _e1520 = global_3.member[bitcast<u32>(select(0i, _e1515, (_e1515 > 0i)))];
let _e1521 = local_12;
let _e1524 = local_13;
let _e1525 = (_e1513 + _e1524);
let _e1527 = select(_e1272, _e1525, (_e1525 < _e1272));
let _e1532 = global_3.member[bitcast<u32>(select(0i, _e1527, (_e1527 > 0i)))];
let _e1533 = local_12;
let _e1538 = (_e1488 + (((_e1480 - _e1450) * _e1139) * _e1144));
let _e1540 = select(_e1272, _e1538, (_e1538 < _e1272));
let _e1545 = global_3.member[bitcast<u32>(select(0i, _e1540, (_e1540 > 0i)))];
let _e1546 = local_12;
let _e1549 = local_13;
let _e1550 = (_e1538 + _e1549);
let _e1552 = select(_e1272, _e1550, (_e1550 < _e1272));
let _e1557 = global_3.member[bitcast<u32>(select(0i, _e1552, (_e1552 > 0i)))];
let _e1558 = local_12;
let _e1562 = (_e1538 + _e1473);
let _e1564 = select(_e1272, _e1562, (_e1562 < _e1272));
let _e1569 = global_3.member[bitcast<u32>(select(0i, _e1564, (_e1564 > 0i)))];
let _e1570 = local_12;
let _e1573 = local_13;
let _e1574 = (_e1562 + _e1573);
let _e1576 = select(_e1272, _e1574, (_e1574 < _e1272));
let _e1581 = global_3.member[bitcast<u32>(select(0i, _e1576, (_e1576 > 0i)))];
let _e1582 = local_12;
phi_2214_ = (_e1114 + 1u);
phi_2217_ = (_e1116 + ((0.5f * (((((((_e1279 * (1f - _e1280)) + (_e1291 * _e1292)) * _e1295) + (((_e1304 * (1f - _e1305)) + (_e1316 * _e1317)) * _e1231)) * (1f - _e1233)) + (((((_e1329 * (1f - _e1330)) + (_e1341 * _e1342)) * _e1295) + (((_e1353 * (1f - _e1354)) + (_e1365 * _e1366)) * _e1231)) * _e1233)) + ((((((_e1495 * (1f - _e1496)) + (_e1507 * _e1508)) * _e1511) + (((_e1520 * (1f - _e1521)) + (_e1532 * _e1533)) * _e1454)) * (1f - _e1456)) + (((((_e1545 * (1f - _e1546)) + (_e1557 * _e1558)) * _e1511) + (((_e1569 * (1f - _e1570)) + (_e1581 * _e1582)) * _e1454)) * _e1456)))) * _e1126));
} else {
phi_2214_ = u32();
phi_2217_ = f32();
}
let _e1597 = phi_2214_;
let _e1599 = phi_2217_;
continue;
continuing {
phi_2213_ = _e1597;
phi_2216_ = _e1599;
break if !(_e1119);
}
}
let _e10387 = local_68;
phi_2938_ = _e10387;
}
let _e1602 = phi_2938_;
let _e1606 = global_5.member.member_13.member;
let _e1611 = -((_e1606.member * _e1602));
let _e1613 = select(-87f, _e1611, (_e1611 > -87f));
let _e1615 = select(88f, _e1613, (_e1613 < 88f));
let _e1617 = ((_e1615 * 1.442695f) + 0.5f);
let _e1619 = select(-127f, _e1617, (_e1617 > -127f));
let _e1621 = select(128f, _e1619, (_e1619 < 128f));
let _e1628 = select(0i, select(select(i32(_e1621), i32(-2147483648), (_e1621 < -2147483600f)), 2147483647i, (_e1621 > 2147483500f)), (_e1621 == _e1621));
let _e1632 = (_e1628 - select(0i, 1i, (_e1621 < f32(_e1628))));
let _e1633 = f32(_e1632);
let _e1637 = ((_e1615 - (_e1633 * 0.6933594f)) - (_e1633 * -2.1219444e-4f));
let _e1659 = -((_e1606.member_1 * _e1602));
let _e1661 = select(-87f, _e1659, (_e1659 > -87f));
let _e1663 = select(88f, _e1661, (_e1661 < 88f));
let _e1665 = ((_e1663 * 1.442695f) + 0.5f);
let _e1667 = select(-127f, _e1665, (_e1665 > -127f));
let _e1669 = select(128f, _e1667, (_e1667 < 128f));
let _e1676 = select(0i, select(select(i32(_e1669), i32(-2147483648), (_e1669 < -2147483600f)), 2147483647i, (_e1669 > 2147483500f)), (_e1669 == _e1669));
let _e1680 = (_e1676 - select(0i, 1i, (_e1669 < f32(_e1676))));
let _e1681 = f32(_e1680);
let _e1685 = ((_e1663 - (_e1681 * 0.6933594f)) - (_e1681 * -2.1219444e-4f));
let _e1707 = -((_e1606.member_2 * _e1602));
let _e1709 = select(-87f, _e1707, (_e1707 > -87f));
let _e1711 = select(88f, _e1709, (_e1709 < 88f));
let _e1713 = ((_e1711 * 1.442695f) + 0.5f);
let _e1715 = select(-127f, _e1713, (_e1713 > -127f));
let _e1717 = select(128f, _e1715, (_e1715 < 128f));
let _e1724 = select(0i, select(select(i32(_e1717), i32(-2147483648), (_e1717 < -2147483600f)), 2147483647i, (_e1717 > 2147483500f)), (_e1717 == _e1717));
let _e1728 = (_e1724 - select(0i, 1i, (_e1717 < f32(_e1724))));
let _e1729 = f32(_e1728);
let _e1733 = ((_e1711 - (_e1729 * 0.6933594f)) - (_e1729 * -2.1219444e-4f));
let _e1756 = (1f / 3f);
let _e1758 = (1f * ((1f + (_e1637 * (1f + (_e1637 * (0.5f + (_e1637 * (0.16666667f + (_e1637 * (0.041666668f + (_e1637 * (0.008333334f + (_e1637 * (0.001388889f + (_e1637 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1632 + 127i)) << bitcast<u32>(23i)))));
let _e1759 = (1f * ((1f + (_e1685 * (1f + (_e1685 * (0.5f + (_e1685 * (0.16666667f + (_e1685 * (0.041666668f + (_e1685 * (0.008333334f + (_e1685 * (0.001388889f + (_e1685 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1680 + 127i)) << bitcast<u32>(23i)))));
let _e1760 = (1f * ((1f + (_e1733 * (1f + (_e1733 * (0.5f + (_e1733 * (0.16666667f + (_e1733 * (0.041666668f + (_e1733 * (0.008333334f + (_e1733 * (0.001388889f + (_e1733 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1728 + 127i)) << bitcast<u32>(23i)))));
let _e1789 = type_27(_e1051.member, _e1051.member_1, _e1051.member_2, _e1051.member_3, _e1051.member_4, _e1051.member_5, vec3<f32>(_e1758, _e1759, _e1760), _e1051.member_7, _e1051.member_8, _e1051.member_9, _e1051.member_10, _e1051.member_11, _e1051.member_12, _e1051.member_13, _e1051.member_14, _e1051.member_15, _e1051.member_16, _e1051.member_17, _e1051.member_18, _e1051.member_19, _e1051.member_20, _e1051.member_21, _e1051.member_22, _e1051.member_23, _e1051.member_24, _e1051.member_25, _e1051.member_26, _e1051.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e733) {
phi_3166_ = ((((1f + 1f) + 1f) * _e1756) - (((_e1758 + _e1759) + _e1760) * _e1756));
} else {
phi_3166_ = 0f;
}
let _e1798 = phi_3166_;
let _e1827 = type_27(_e1789.member, _e1789.member_1, _e1789.member_2, _e1789.member_3, _e1789.member_4, _e1789.member_5, _e1789.member_6, _e1789.member_7, _e1789.member_8, _e1789.member_9, _e1789.member_10, _e1789.member_11, _e1789.member_12, _e1789.member_13, _e1789.member_14, _e1789.member_15, _e1789.member_16, _e1789.member_17, _e1789.member_18, _e1789.member_19, _e1789.member_20, _e1789.member_21, _e1789.member_22, _e1789.member_23, _e1789.member_24, _e1789.member_25, (_e612 + _e1798), _e1789.member_27);
if _e962 {
let _e1857 = type_27(_e1827.member, _e1827.member_1, _e1827.member_2, _e1827.member_3, _e1827.member_4, _e1827.member_5, _e1827.member_6, _e1827.member_7, (bitcast<i32>(_e141) / 8i), _e1827.member_9, _e1827.member_10, _e1827.member_11, _e1827.member_12, _e1827.member_13, _e1827.member_14, _e1827.member_15, _e1827.member_16, _e1827.member_17, _e1827.member_18, _e1827.member_19, _e1827.member_20, _e1827.member_21, _e1827.member_22, _e1827.member_23, _e1827.member_24, _e1827.member_25, _e1827.member_26, _e1827.member_27);
phi_3193_ = type_27(_e1857.member, _e1857.member_1, _e1857.member_2, _e1857.member_3, _e1857.member_4, _e1857.member_5, _e1857.member_6, _e1857.member_7, _e1857.member_8, _e1857.member_9, _e1857.member_10, _e1857.member_11, _e1857.member_12, _e1857.member_13, _e1857.member_14, 3f, _e1857.member_16, _e1857.member_17, _e1857.member_18, _e1857.member_19, _e1857.member_20, _e1857.member_21, _e1857.member_22, _e1857.member_23, _e1857.member_24, _e1857.member_25, _e1857.member_26, _e1857.member_27);
} else {
phi_3193_ = _e1827;
}
let _e1887 = phi_3193_;
phi_3194_ = _e1887;
} else {
phi_3194_ = type_27(vec3<f32>(_e173, _e183, _e194), vec3<f32>(_e205, _e216, _e227), vec3<f32>(_e238, _e249, _e260), vec3<f32>(_e271, _e282, _e293), vec3<f32>(_e304, _e315, _e326), vec3<f32>(_e337, _e348, _e359), vec3<f32>(_e370, _e381, _e392), select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < -2147483600f)), 2147483647i, (_e403 > 2147483500f)), (_e403 == _e403)), select(0i, select(select(i32(_e414), i32(-2147483648), (_e414 < -2147483600f)), 2147483647i, (_e414 > 2147483500f)), (_e414 == _e414)), select(0i, select(select(i32(_e425), i32(-2147483648), (_e425 < -2147483600f)), 2147483647i, (_e425 > 2147483500f)), (_e425 == _e425)), _e436, select(0i, select(select(i32(_e447), i32(-2147483648), (_e447 < -2147483600f)), 2147483647i, (_e447 > 2147483500f)), (_e447 == _e447)), select(0i, select(select(i32(_e458), i32(-2147483648), (_e458 < -2147483600f)), 2147483647i, (_e458 > 2147483500f)), (_e458 == _e458)), _e469, _e480, _e491, select(0i, select(select(i32(_e502), i32(-2147483648), (_e502 < -2147483600f)), 2147483647i, (_e502 > 2147483500f)), (_e502 == _e502)), _e712, _e719, _e726, _e733, _e740, _e630, _e579, _e590, _e601, _e612, _e623);
}
let _e1889 = phi_3194_;
let _e1890 = bitcast<i32>(_e141);
let _e1891 = (_e1890 / 8i);
let _e1893 = (_e1889.member_15 == 2f);
if _e1893 {
phi_3214_ = type_27(_e1889.member, _e1889.member_1, _e1889.member_2, _e1889.member_3, _e1889.member_4, _e1889.member_5, _e1889.member_6, _e1889.member_7, _e1889.member_8, _e1889.member_9, _e1889.member_10, _e1889.member_11, _e1889.member_12, _e1889.member_13, _e1889.member_14, 1f, _e1889.member_16, _e1889.member_17, _e1889.member_18, _e1889.member_19, _e1889.member_20, _e1889.member_21, _e1889.member_22, _e1889.member_23, _e1889.member_24, _e1889.member_25, _e1889.member_26, _e1889.member_27);
} else {
phi_3214_ = _e1889;
}
let _e1923 = phi_3214_;
phi_3216_ = _e1923;
phi_3219_ = 0i;
phi_3221_ = _e1893;
loop {
let _e1925 = phi_3216_;
let _e1927 = phi_3219_;
let _e1929 = phi_3221_;
local_26 = _e1925;
local_27 = _e1925;
local_28 = _e1925;
local_29 = _e1925;
local_30 = _e1925;
local_31 = _e1925;
local_32 = _e1925;
local_33 = _e1925;
local_34 = _e1925;
local_35 = _e1925;
local_36 = _e1925;
local_37 = _e1925;
local_38 = _e1925;
local_39 = _e1925;
local_40 = _e1925;
local_41 = _e1925;
local_42 = _e1925;
local_43 = _e1925;
local_44 = _e1925;
local_45 = _e1925;
local_46 = _e1925;
local_47 = _e1925;
local_48 = _e1925;
local_49 = _e1925;
local_50 = _e1925;
local_51 = _e1925;
local_52 = _e1925;
local_53 = _e1925;
local_54 = _e1925;
local_55 = _e1925;
local_56 = _e1925;
local_57 = _e1925;
local_58 = _e1925;
local_59 = _e1925;
local_60 = _e1925;
local_61 = _e1925;
local_62 = _e1925;
local_63 = _e1925;
local_64 = _e1925;
local_65 = _e1925;
local_66 = _e1925;
let _e1933 = ((_e1927 < 1024i) && (_e1925.member_15 == 1f));
local_67 = _e1925.member_15;
if _e1933 {
if (_e1925.member_8 < _e1891) {
let _e9273 = f32(_e1925.member_11);
let _e9275 = f32(_e1925.member_12);
let _e9277 = vec3<f32>(_e9273, _e9275, _e1925.member_13);
let _e9279 = (_e1925.member_9 >= 0i);
if _e9279 {
let _e9280 = (_e1925.member_9 * 19i);
let _e9282 = (bitcast<i32>(_e143) - 1i);
let _e9284 = select(_e9282, _e9280, (_e9280 < _e9282));
let _e9290 = global_2.member[bitcast<u32>(select(0i, _e9284, (_e9284 > 0i)))];
let _e9291 = (_e9280 + 1i);
let _e9293 = select(_e9282, _e9291, (_e9291 < _e9282));
let _e9299 = global_2.member[bitcast<u32>(select(0i, _e9293, (_e9293 > 0i)))];
let _e9300 = (_e9280 + 2i);
let _e9302 = select(_e9282, _e9300, (_e9300 < _e9282));
let _e9308 = global_2.member[bitcast<u32>(select(0i, _e9302, (_e9302 > 0i)))];
let _e9309 = (_e9280 + 3i);
let _e9311 = select(_e9282, _e9309, (_e9309 < _e9282));
let _e9317 = global_2.member[bitcast<u32>(select(0i, _e9311, (_e9311 > 0i)))];
let _e9318 = (_e9280 + 4i);
let _e9320 = select(_e9282, _e9318, (_e9318 < _e9282));
let _e9326 = global_2.member[bitcast<u32>(select(0i, _e9320, (_e9320 > 0i)))];
let _e9327 = (_e9280 + 5i);
let _e9329 = select(_e9282, _e9327, (_e9327 < _e9282));
let _e9335 = global_2.member[bitcast<u32>(select(0i, _e9329, (_e9329 > 0i)))];
let _e9336 = (_e9317 - _e9290);
let _e9337 = (_e9326 - _e9299);
let _e9338 = (_e9335 - _e9308);
let _e9339 = (_e9280 + 6i);
let _e9341 = select(_e9282, _e9339, (_e9339 < _e9282));
let _e9347 = global_2.member[bitcast<u32>(select(0i, _e9341, (_e9341 > 0i)))];
let _e9348 = (_e9280 + 7i);
let _e9350 = select(_e9282, _e9348, (_e9348 < _e9282));
let _e9356 = global_2.member[bitcast<u32>(select(0i, _e9350, (_e9350 > 0i)))];
let _e9357 = (_e9280 + 8i);
let _e9359 = select(_e9282, _e9357, (_e9357 < _e9282));
let _e9365 = global_2.member[bitcast<u32>(select(0i, _e9359, (_e9359 > 0i)))];
let _e9366 = (_e9347 - _e9290);
let _e9367 = (_e9356 - _e9299);
let _e9368 = (_e9365 - _e9308);
let _e9371 = ((_e9337 * _e9368) - (_e9338 * _e9367));
let _e9374 = ((_e9338 * _e9366) - (_e9336 * _e9368));
let _e9377 = ((_e9336 * _e9367) - (_e9337 * _e9366));
let _e9382 = (((_e9371 * _e9371) + (_e9374 * _e9374)) + (_e9377 * _e9377));
let _e9385 = sqrt(select(0f, _e9382, (_e9382 > 0f)));
let _e9388 = (1f / select(1e-20f, _e9385, (_e9385 > 1e-20f)));
phi_3447_ = (((_e1925.member_1.x * (_e9371 * _e9388)) + (_e1925.member_1.y * (_e9374 * _e9388))) + (_e1925.member_1.z * (_e9377 * _e9388)));
} else {
phi_3447_ = 1f;
}
let _e9401 = phi_3447_;
let _e9408 = select(0i, select(select(i32(_e9273), i32(-2147483648), (_e9273 < -2147483600f)), 2147483647i, (_e9273 > 2147483500f)), (_e9273 == _e9273));
let _e9415 = select(0i, select(select(i32(_e9275), i32(-2147483648), (_e9275 < -2147483600f)), 2147483647i, (_e9275 > 2147483500f)), (_e9275 == _e9275));
let _e9418 = bitcast<f32>((bitcast<u32>(_e9401) & 2147483647u));
let _e9420 = select(1e-3f, _e9418, (_e9418 > 1e-3f));
let _e9421 = type_28(_e9408, _e9415, _e1925.member_13, _e1925.member_14, _e9420);
let _e9426 = global_5.member.member_12.member;
let _e9429 = (_e1925.member_10 + select(0f, (_e9426 / _e9420), _e9279));
let _e9433 = (_e1925.member_8 * 8i);
let _e9436 = bitcast<f32>((bitcast<u32>(_e1925.member_1.x) & 2147483647u));
let _e9441 = (1f / select(_e1925.member_1.x, select(1e-12f, -1e-12f, (_e1925.member_1.x < 0f)), (_e9436 < 1e-12f)));
let _e9444 = bitcast<f32>((bitcast<u32>(_e1925.member_1.y) & 2147483647u));
let _e9449 = (1f / select(_e1925.member_1.y, select(1e-12f, -1e-12f, (_e1925.member_1.y < 0f)), (_e9444 < 1e-12f)));
let _e9452 = bitcast<f32>((bitcast<u32>(_e1925.member_1.z) & 2147483647u));
let _e9457 = (1f / select(_e1925.member_1.z, select(1e-12f, -1e-12f, (_e1925.member_1.z < 0f)), (_e9452 < 1e-12f)));
let _e9458 = (_e1890 - 1i);
let _e9460 = select(_e9458, _e9433, (_e9433 < _e9458));
let _e9466 = global_1.member[bitcast<u32>(select(0i, _e9460, (_e9460 > 0i)))];
let _e9467 = (_e9433 + 1i);
let _e9469 = select(_e9458, _e9467, (_e9467 < _e9458));
let _e9475 = global_1.member[bitcast<u32>(select(0i, _e9469, (_e9469 > 0i)))];
let _e9476 = (_e9433 + 2i);
let _e9478 = select(_e9458, _e9476, (_e9476 < _e9458));
let _e9484 = global_1.member[bitcast<u32>(select(0i, _e9478, (_e9478 > 0i)))];
let _e9485 = (_e9433 + 3i);
let _e9487 = select(_e9458, _e9485, (_e9485 < _e9458));
let _e9493 = global_1.member[bitcast<u32>(select(0i, _e9487, (_e9487 > 0i)))];
let _e9494 = (_e9433 + 4i);
let _e9496 = select(_e9458, _e9494, (_e9494 < _e9458));
let _e9502 = global_1.member[bitcast<u32>(select(0i, _e9496, (_e9496 > 0i)))];
let _e9503 = (_e9433 + 5i);
let _e9505 = select(_e9458, _e9503, (_e9503 < _e9458));
let _e9511 = global_1.member[bitcast<u32>(select(0i, _e9505, (_e9505 > 0i)))];
let _e9514 = ((_e9466 - _e1925.member.x) * _e9441);
let _e9516 = ((_e9493 - _e1925.member.x) * _e9441);
let _e9519 = ((_e9475 - _e1925.member.y) * _e9449);
let _e9521 = ((_e9502 - _e1925.member.y) * _e9449);
let _e9524 = ((_e9484 - _e1925.member.z) * _e9457);
let _e9526 = ((_e9511 - _e1925.member.z) * _e9457);
let _e9528 = select(_e9516, _e9514, (_e9514 < _e9516));
let _e9530 = select(_e9521, _e9519, (_e9519 < _e9521));
let _e9532 = select(_e9530, _e9528, (_e9528 > _e9530));
let _e9534 = select(_e9526, _e9524, (_e9524 < _e9526));
let _e9538 = select(_e9516, _e9514, (_e9514 > _e9516));
let _e9540 = select(_e9521, _e9519, (_e9519 > _e9521));
let _e9542 = select(_e9540, _e9538, (_e9538 < _e9540));
let _e9544 = select(_e9526, _e9524, (_e9524 > _e9526));
let _e9546 = select(_e9544, _e9542, (_e9542 < _e9544));
let _e9551 = ((select(_e9534, _e9532, (_e9532 > _e9534)) <= select(_e9429, _e9546, (_e9546 < _e9429))) && (_e9546 >= _e1925.member_13));
let _e9552 = (_e9433 + 6i);
let _e9554 = select(_e9458, _e9552, (_e9552 < _e9458));
let _e9560 = global_1.member[bitcast<u32>(select(0i, _e9554, (_e9554 > 0i)))];
if _e9551 {
phi_3760_ = (_e1925.member_8 + 1i);
} else {
let _e9568 = (_e9433 + 7i);
let _e9570 = select(_e9458, _e9568, (_e9568 < _e9458));
let _e9576 = global_1.member[bitcast<u32>(select(0i, _e9570, (_e9570 > 0i)))];
phi_3760_ = select(0i, select(select(i32(_e9576), i32(-2147483648), (_e9576 < -2147483600f)), 2147483647i, (_e9576 > 2147483500f)), (_e9576 == _e9576));
}
let _e9586 = phi_3760_;
let _e9587 = type_19(_e1925.member, _e1925.member_1, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), _e9277, _e1925.member_14, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, _e9586, _e1925.member_9, _e1925.member_10);
let _e9588 = select(-1i, select(0i, select(select(i32(_e9560), i32(-2147483648), (_e9560 < -2147483600f)), 2147483647i, (_e9560 > 2147483500f)), (_e9560 == _e9560)), _e9551);
if (_e9588 < 0i) {
phi_4540_ = type_28();
phi_4541_ = type_19();
phi_4542_ = true;
} else {
let _e9592 = ((_e9436 >= _e9444) && (_e9436 >= _e9452));
let _e9595 = (!(_e9592) && (_e9444 >= _e9452));
let _e9602 = (1f / select(select(_e1925.member_1.z, _e1925.member_1.y, _e9595), _e1925.member_1.x, _e9592));
let _e9603 = (select(select(_e1925.member_1.x, _e1925.member_1.z, _e9595), _e1925.member_1.y, _e9592) * _e9602);
let _e9604 = (select(select(_e1925.member_1.y, _e1925.member_1.x, _e9595), _e1925.member_1.z, _e9592) * _e9602);
let _e9605 = (_e9588 * 19i);
let _e9607 = (bitcast<i32>(_e143) - 1i);
let _e9609 = select(_e9607, _e9605, (_e9605 < _e9607));
let _e9615 = global_2.member[bitcast<u32>(select(0i, _e9609, (_e9609 > 0i)))];
let _e9616 = (_e9605 + 1i);
let _e9618 = select(_e9607, _e9616, (_e9616 < _e9607));
let _e9624 = global_2.member[bitcast<u32>(select(0i, _e9618, (_e9618 > 0i)))];
let _e9625 = (_e9605 + 2i);
let _e9627 = select(_e9607, _e9625, (_e9625 < _e9607));
let _e9633 = global_2.member[bitcast<u32>(select(0i, _e9627, (_e9627 > 0i)))];
let _e9634 = (_e9615 - _e1925.member.x);
let _e9635 = (_e9624 - _e1925.member.y);
let _e9636 = (_e9633 - _e1925.member.z);
let _e9642 = select(select(_e9636, _e9635, _e9595), _e9634, _e9592);
let _e9644 = (select(select(_e9634, _e9636, _e9595), _e9635, _e9592) - (_e9603 * _e9642));
let _e9646 = (select(select(_e9635, _e9634, _e9595), _e9636, _e9592) - (_e9604 * _e9642));
let _e9648 = (_e9605 + 3i);
let _e9650 = select(_e9607, _e9648, (_e9648 < _e9607));
let _e9656 = global_2.member[bitcast<u32>(select(0i, _e9650, (_e9650 > 0i)))];
let _e9657 = (_e9605 + 4i);
let _e9659 = select(_e9607, _e9657, (_e9657 < _e9607));
let _e9665 = global_2.member[bitcast<u32>(select(0i, _e9659, (_e9659 > 0i)))];
let _e9666 = (_e9605 + 5i);
let _e9668 = select(_e9607, _e9666, (_e9666 < _e9607));
let _e9674 = global_2.member[bitcast<u32>(select(0i, _e9668, (_e9668 > 0i)))];
let _e9675 = (_e9656 - _e1925.member.x);
let _e9676 = (_e9665 - _e1925.member.y);
let _e9677 = (_e9674 - _e1925.member.z);
let _e9683 = select(select(_e9677, _e9676, _e9595), _e9675, _e9592);
let _e9685 = (select(select(_e9675, _e9677, _e9595), _e9676, _e9592) - (_e9603 * _e9683));
let _e9687 = (select(select(_e9676, _e9675, _e9595), _e9677, _e9592) - (_e9604 * _e9683));
let _e9689 = (_e9605 + 6i);
let _e9691 = select(_e9607, _e9689, (_e9689 < _e9607));
let _e9697 = global_2.member[bitcast<u32>(select(0i, _e9691, (_e9691 > 0i)))];
let _e9698 = (_e9605 + 7i);
let _e9700 = select(_e9607, _e9698, (_e9698 < _e9607));
let _e9706 = global_2.member[bitcast<u32>(select(0i, _e9700, (_e9700 > 0i)))];
let _e9707 = (_e9605 + 8i);
let _e9709 = select(_e9607, _e9707, (_e9707 < _e9607));
let _e9715 = global_2.member[bitcast<u32>(select(0i, _e9709, (_e9709 > 0i)))];
let _e9716 = (_e9697 - _e1925.member.x);
let _e9717 = (_e9706 - _e1925.member.y);
let _e9718 = (_e9715 - _e1925.member.z);
let _e9724 = select(select(_e9718, _e9717, _e9595), _e9716, _e9592);
let _e9726 = (select(select(_e9716, _e9718, _e9595), _e9717, _e9592) - (_e9603 * _e9724));
let _e9728 = (select(select(_e9717, _e9716, _e9595), _e9718, _e9592) - (_e9604 * _e9724));
let _e9732 = ((_e9726 * _e9687) - (_e9728 * _e9685));
let _e9735 = ((_e9644 * _e9728) - (_e9646 * _e9726));
let _e9738 = ((_e9685 * _e9646) - (_e9687 * _e9644));
let _e9740 = ((_e9732 + _e9735) + _e9738);
let _e9754 = (!(((((_e9732 < 0f) || (_e9735 < 0f)) || (_e9738 < 0f)) && (((_e9732 > 0f) || (_e9735 > 0f)) || (_e9738 > 0f)))) && (_e9740 != 0f));
let _e9762 = select(1e30f, ((((_e9732 * (_e9642 * _e9602)) + (_e9735 * (_e9683 * _e9602))) + (_e9738 * (_e9724 * _e9602))) / select(1f, _e9740, _e9754)), _e9754);
if (_e9762 >= _e9429) {
phi_4534_ = type_28();
phi_4535_ = type_19();
phi_4536_ = true;
} else {
let _e9764 = (_e9656 - _e9615);
let _e9765 = (_e9665 - _e9624);
let _e9766 = (_e9674 - _e9633);
let _e9767 = (_e9697 - _e9615);
let _e9768 = (_e9706 - _e9624);
let _e9769 = (_e9715 - _e9633);
let _e9772 = ((_e9765 * _e9769) - (_e9766 * _e9768));
let _e9775 = ((_e9766 * _e9767) - (_e9764 * _e9769));
let _e9778 = ((_e9764 * _e9768) - (_e9765 * _e9767));
let _e9783 = (((_e9772 * _e9772) + (_e9775 * _e9775)) + (_e9778 * _e9778));
let _e9786 = sqrt(select(0f, _e9783, (_e9783 > 0f)));
let _e9789 = (1f / select(1e-20f, _e9786, (_e9786 > 1e-20f)));
let _e9797 = (((_e1925.member_1.x * (_e9772 * _e9789)) + (_e1925.member_1.y * (_e9775 * _e9789))) + (_e1925.member_1.z * (_e9778 * _e9789)));
let _e9800 = bitcast<f32>((bitcast<u32>(_e9797) & 2147483647u));
let _e9802 = select(1e-3f, _e9800, (_e9800 > 1e-3f));
let _e9803 = (_e9605 + 18i);
let _e9805 = select(_e9607, _e9803, (_e9803 < _e9607));
let _e9811 = global_2.member[bitcast<u32>(select(0i, _e9805, (_e9805 > 0i)))];
let _e9818 = select(0i, select(select(i32(_e9811), i32(-2147483648), (_e9811 < -2147483600f)), 2147483647i, (_e9811 > 2147483500f)), (_e9811 == _e9811));
let _e9819 = (_e9818 * 4i);
let _e9821 = (bitcast<i32>(_e146) - 1i);
let _e9823 = select(_e9821, _e9819, (_e9819 < _e9821));
let _e9829 = global_3.member[bitcast<u32>(select(0i, _e9823, (_e9823 > 0i)))];
let _e9831 = select(_e9829, 1f, (_e9818 == 16i));
let _e9832 = (_e9831 <= 0f);
if _e9832 {
phi_4371_ = 0i;
} else {
phi_4371_ = (1i << bitcast<u32>((_e9818 & 31i)));
}
let _e9837 = phi_4371_;
let _e9838 = (_e9797 < 0f);
let _e9839 = select(_e9837, 0i, _e9838);
let _e9840 = select(0i, _e9837, _e9838);
let _e9849 = (_e9762 * _e9802);
let _e9862 = (((_e9762 > _e1925.member_13) && (_e1925.member_13 > 0f)) || (((_e9849 > (_e9426 * 2f)) || ((((_e9831 == 0f) || ((_e9840 & ~(_e1925.member_7)) != 0i)) || ((_e9839 & _e1925.member_7) != 0i)) && (_e9849 >= -((_e9426 * 0.5f))))) && (_e1925.member_13 <= 0f)));
if _e9862 {
let _e9863 = (_e9762 < _e1925.member_10);
if (_e9279 && ((bitcast<f32>((bitcast<u32>((_e9762 - _e1925.member_10)) & 2147483647u)) * select(_e9420, _e9802, (_e9802 > _e9420))) <= _e9426)) {
let _e9882 = ((_e1925.member_9 * 19i) + 18i);
let _e9884 = select(_e9607, _e9882, (_e9882 < _e9607));
let _e9890 = global_2.member[bitcast<u32>(select(0i, _e9884, (_e9884 > 0i)))];
let _e9897 = select(0i, select(select(i32(_e9890), i32(-2147483648), (_e9890 < -2147483600f)), 2147483647i, (_e9890 > 2147483500f)), (_e9890 == _e9890));
let _e9898 = (_e9897 * 4i);
let _e9900 = select(_e9821, _e9898, (_e9898 < _e9821));
let _e9906 = global_3.member[bitcast<u32>(select(0i, _e9900, (_e9900 > 0i)))];
if (_e9832 != (select(_e9906, 1f, (_e9897 == 16i)) <= 0f)) {
phi_4516_ = _e9832;
} else {
if (!(_e9832) && (_e9818 != _e9897)) {
phi_4515_ = (_e9818 < _e9897);
} else {
phi_4515_ = _e9863;
}
let _e9916 = phi_4515_;
phi_4516_ = _e9916;
}
let _e9918 = phi_4516_;
phi_4522_ = type_28((_e9408 | _e9840), (_e9415 | _e9839), _e1925.member_13, select(_e9762, _e1925.member_14, (_e1925.member_14 > _e9762)), _e9420);
phi_4523_ = _e9918;
} else {
if _e9863 {
phi_4521_ = type_28(_e9840, _e9839, _e1925.member_13, _e9762, _e9420);
} else {
phi_4521_ = _e9421;
}
let _e9875 = phi_4521_;
phi_4522_ = _e9875;
phi_4523_ = _e9863;
}
let _e9920 = phi_4522_;
let _e9922 = phi_4523_;
if _e9922 {
phi_4530_ = type_19(_e1925.member, _e1925.member_1, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), _e9277, _e1925.member_14, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, _e9586, _e9588, _e9762);
} else {
phi_4530_ = _e9587;
}
let _e9925 = phi_4530_;
phi_4531_ = _e9920;
phi_4532_ = _e9925;
} else {
phi_4531_ = type_28();
phi_4532_ = type_19();
}
let _e9927 = phi_4531_;
let _e9929 = phi_4532_;
phi_4534_ = _e9927;
phi_4535_ = _e9929;
phi_4536_ = select(true, false, _e9862);
}
let _e9932 = phi_4534_;
let _e9934 = phi_4535_;
let _e9936 = phi_4536_;
phi_4540_ = _e9932;
phi_4541_ = _e9934;
phi_4542_ = _e9936;
}
let _e9938 = phi_4540_;
let _e9940 = phi_4541_;
let _e9942 = phi_4542_;
if _e9942 {
phi_4546_ = _e9421;
phi_4547_ = _e9587;
} else {
phi_4546_ = _e9938;
phi_4547_ = _e9940;
}
let _e9944 = phi_4546_;
let _e9946 = phi_4547_;
let _e9975 = type_27(_e1925.member, _e1925.member_1, _e1925.member_2, _e1925.member_3, _e1925.member_4, _e1925.member_5, _e1925.member_6, _e1925.member_7, _e9946.member_15, _e1925.member_9, _e1925.member_10, _e1925.member_11, _e1925.member_12, _e1925.member_13, _e1925.member_14, _e1925.member_15, _e1925.member_16, _e1925.member_17, _e1925.member_18, _e1925.member_19, _e1925.member_20, _e1925.member_21, _e1925.member_22, _e1925.member_23, _e1925.member_24, _e1925.member_25, _e1925.member_26, _e1925.member_27);
let _e10004 = type_27(_e9975.member, _e9975.member_1, _e9975.member_2, _e9975.member_3, _e9975.member_4, _e9975.member_5, _e9975.member_6, _e9975.member_7, _e9975.member_8, _e9946.member_16, _e9975.member_10, _e9975.member_11, _e9975.member_12, _e9975.member_13, _e9975.member_14, _e9975.member_15, _e9975.member_16, _e9975.member_17, _e9975.member_18, _e9975.member_19, _e9975.member_20, _e9975.member_21, _e9975.member_22, _e9975.member_23, _e9975.member_24, _e9975.member_25, _e9975.member_26, _e9975.member_27);
let _e10033 = type_27(_e10004.member, _e10004.member_1, _e10004.member_2, _e10004.member_3, _e10004.member_4, _e10004.member_5, _e10004.member_6, _e10004.member_7, _e10004.member_8, _e10004.member_9, _e9946.member_17, _e10004.member_11, _e10004.member_12, _e10004.member_13, _e10004.member_14, _e10004.member_15, _e10004.member_16, _e10004.member_17, _e10004.member_18, _e10004.member_19, _e10004.member_20, _e10004.member_21, _e10004.member_22, _e10004.member_23, _e10004.member_24, _e10004.member_25, _e10004.member_26, _e10004.member_27);
let _e10062 = type_27(_e10033.member, _e10033.member_1, _e10033.member_2, _e10033.member_3, _e10033.member_4, _e10033.member_5, _e10033.member_6, _e10033.member_7, _e10033.member_8, _e10033.member_9, _e10033.member_10, _e9944.member, _e10033.member_12, _e10033.member_13, _e10033.member_14, _e10033.member_15, _e10033.member_16, _e10033.member_17, _e10033.member_18, _e10033.member_19, _e10033.member_20, _e10033.member_21, _e10033.member_22, _e10033.member_23, _e10033.member_24, _e10033.member_25, _e10033.member_26, _e10033.member_27);
let _e10091 = type_27(_e10062.member, _e10062.member_1, _e10062.member_2, _e10062.member_3, _e10062.member_4, _e10062.member_5, _e10062.member_6, _e10062.member_7, _e10062.member_8, _e10062.member_9, _e10062.member_10, _e10062.member_11, _e9944.member_1, _e10062.member_13, _e10062.member_14, _e10062.member_15, _e10062.member_16, _e10062.member_17, _e10062.member_18, _e10062.member_19, _e10062.member_20, _e10062.member_21, _e10062.member_22, _e10062.member_23, _e10062.member_24, _e10062.member_25, _e10062.member_26, _e10062.member_27);
phi_12424_ = type_27(_e10091.member, _e10091.member_1, _e10091.member_2, _e10091.member_3, _e10091.member_4, _e10091.member_5, _e10091.member_6, _e10091.member_7, _e10091.member_8, _e10091.member_9, _e10091.member_10, _e10091.member_11, _e10091.member_12, _e10091.member_13, _e9944.member_3, _e10091.member_15, _e10091.member_16, _e10091.member_17, _e10091.member_18, _e10091.member_19, _e10091.member_20, _e10091.member_21, _e10091.member_22, _e10091.member_23, _e10091.member_24, _e10091.member_25, _e10091.member_26, _e10091.member_27);
phi_12425_ = _e1929;
} else {
phi_4562_ = 15i;
phi_4565_ = 16i;
loop {
let _e1939 = phi_4562_;
let _e1941 = phi_4565_;
local_16 = _e1941;
local_17 = _e1941;
local_18 = _e1941;
local_20 = _e1941;
local_23 = _e1941;
let _e1942 = (_e1939 >= 0i);
if _e1942 {
phi_4563_ = (_e1939 - 1i);
phi_4566_ = select(_e1941, _e1939, (((_e1925.member_7 >> bitcast<u32>((_e1939 & 31i))) & 1i) == 1i));
} else {
phi_4563_ = i32();
phi_4566_ = i32();
}
let _e1951 = phi_4563_;
let _e1953 = phi_4566_;
continue;
continuing {
phi_4562_ = _e1951;
phi_4565_ = _e1953;
break if !(_e1942);
}
}
let _e1956 = local_16;
let _e1957 = (_e1956 == 16i);
let _e1969 = (bitcast<i32>(countOneBits(bitcast<u32>((_e1925.member_17 & ((1i << bitcast<u32>((_e1925.member_16 & 31i))) - 1i))))) == _e1925.member_20);
let _e1972 = ((_e1957 && _e1969) && !(_e1929));
if _e1972 {
let _e9234 = type_27(_e1925.member, _e1925.member_1, _e1925.member_2, _e1925.member_3, _e1925.member_4, _e1925.member_5, _e1925.member_6, _e1925.member_7, _e1925.member_8, _e1925.member_9, _e1925.member_10, _e1925.member_11, _e1925.member_12, _e1925.member_13, _e1925.member_14, 2f, _e1925.member_16, _e1925.member_17, _e1925.member_18, _e1925.member_19, _e1925.member_20, _e1925.member_21, _e1925.member_22, _e1925.member_23, _e1925.member_24, _e1925.member_25, _e1925.member_26, _e1925.member_27);
phi_12422_ = type_27(_e9234.member, _e9234.member_1, _e9234.member_2, _e9234.member_3, _e9234.member_4, _e9234.member_5, _e9234.member_6, _e9234.member_7, _e9234.member_8, _e9234.member_9, _e9234.member_10, _e9234.member_11, _e9234.member_12, _e9234.member_13, _e9234.member_14, _e9234.member_15, _e9234.member_16, _e9234.member_17, _e9234.member_18, _e9234.member_19, _e9234.member_20, _e9234.member_21, (_e1925.member_22 + 1i), _e9234.member_23, _e9234.member_24, _e9234.member_25, _e9234.member_26, _e9234.member_27);
} else {
let _e1974 = (_e1925.member_9 >= 0i);
let _e1977 = (_e1925.member_10 - _e1925.member_13);
let _e1979 = select(0f, _e1977, (_e1977 > 0f));
let _e1982 = ((select(0i, _e1925.member_9, _e1974) * 19i) + 18i);
let _e1984 = (bitcast<i32>(_e143) - 1i);
let _e1986 = select(_e1984, _e1982, (_e1982 < _e1984));
let _e1992 = global_2.member[bitcast<u32>(select(0i, _e1986, (_e1986 > 0i)))];
let _e1999 = select(0i, select(select(i32(_e1992), i32(-2147483648), (_e1992 < -2147483600f)), 2147483647i, (_e1992 > 2147483500f)), (_e1992 == _e1992));
let _e2000 = (_e1999 * 4i);
let _e2002 = (bitcast<i32>(_e146) - 1i);
let _e2004 = select(_e2002, _e2000, (_e2000 < _e2002));
let _e2010 = global_3.member[bitcast<u32>(select(0i, _e2004, (_e2004 > 0i)))];
let _e2012 = select(_e2010, 1f, (_e1999 == 16i));
let _e2014 = (_e1974 && (_e2012 <= 0f));
let _e2023 = ((_e1925.member_7 | (_e1925.member_11 & ~(_e1925.member_12))) & ~((_e1925.member_12 & ~(_e1925.member_11))));
phi_4684_ = 15i;
phi_4687_ = 16i;
loop {
let _e2025 = phi_4684_;
let _e2027 = phi_4687_;
local_19 = _e2027;
local_21 = _e2027;
local_22 = _e2027;
local_24 = _e2027;
local_25 = _e2027;
let _e2028 = (_e2025 >= 0i);
if _e2028 {
phi_4685_ = (_e2025 - 1i);
phi_4688_ = select(_e2027, _e2025, (((_e2023 >> bitcast<u32>((_e2025 & 31i))) & 1i) == 1i));
} else {
phi_4685_ = i32();
phi_4688_ = i32();
}
let _e2037 = phi_4685_;
let _e2039 = phi_4688_;
continue;
continuing {
phi_4684_ = _e2037;
phi_4687_ = _e2039;
break if !(_e2028);
}
}
if _e1957 {
let _e2309 = (1f / select(_e1925.member_1.x, select(1e-12f, -1e-12f, (_e1925.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e1925.member_1.x) & 2147483647u)) < 1e-12f)));
let _e2318 = (1f / select(_e1925.member_1.y, select(1e-12f, -1e-12f, (_e1925.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e1925.member_1.y) & 2147483647u)) < 1e-12f)));
let _e2327 = (1f / select(_e1925.member_1.z, select(1e-12f, -1e-12f, (_e1925.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e1925.member_1.z) & 2147483647u)) < 1e-12f)));
let _e2331 = global_5.member.member_13.member_4;
let _e2338 = global_5.member.member_13.member_5;
let _e2344 = ((_e2331.member - _e1925.member.x) * _e2309);
let _e2346 = ((_e2338.member - _e1925.member.x) * _e2309);
let _e2349 = ((_e2331.member_1 - _e1925.member.y) * _e2318);
let _e2351 = ((_e2338.member_1 - _e1925.member.y) * _e2318);
let _e2354 = ((_e2331.member_2 - _e1925.member.z) * _e2327);
let _e2356 = ((_e2338.member_2 - _e1925.member.z) * _e2327);
let _e2358 = select(_e2346, _e2344, (_e2344 < _e2346));
let _e2360 = select(_e2351, _e2349, (_e2349 < _e2351));
let _e2362 = select(_e2360, _e2358, (_e2358 > _e2360));
let _e2364 = select(_e2356, _e2354, (_e2354 < _e2356));
let _e2366 = select(_e2364, _e2362, (_e2362 > _e2364));
let _e2368 = select(_e2346, _e2344, (_e2344 > _e2346));
let _e2370 = select(_e2351, _e2349, (_e2349 > _e2351));
let _e2372 = select(_e2370, _e2368, (_e2368 < _e2370));
let _e2374 = select(_e2356, _e2354, (_e2354 > _e2356));
let _e2376 = select(_e2374, _e2372, (_e2372 < _e2374));
let _e2378 = select(0f, _e2366, (_e2366 > 0f));
let _e2380 = select(_e1925.member_10, _e2376, (_e2376 < _e1925.member_10));
let _e2381 = (_e2380 > _e2378);
let _e2382 = select(0f, _e2378, _e2381);
let _e2384 = (select(0f, _e2380, _e2381) - _e2382);
let _e2388 = global_5.member.member_13.member_6;
if (_e2388 == 0u) {
phi_5591_ = _e2384;
} else {
let _e2391 = (_e2384 / f32(_e2388));
phi_4866_ = 0u;
phi_4869_ = 0f;
loop {
let _e2393 = phi_4866_;
let _e2395 = phi_4869_;
local_69 = _e2395;
let _e2398 = ((_e2393 < _e2388) && (_e2384 > 0f));
if _e2398 {
let _e2401 = (_e2382 + (_e2391 * f32(_e2393)));
let _e2402 = (_e2401 + _e2391);
let _e2404 = (0.5f * (_e2401 + _e2402));
let _e2405 = (_e2402 - _e2401);
let _e2406 = (0.28867513f * _e2405);
let _e2407 = (_e2404 - _e2406);
let _e2417 = global_5.member.member_13.member_7;
let _e2418 = bitcast<i32>(_e2417);
let _e2422 = global_5.member.member_13.member_8;
let _e2423 = bitcast<i32>(_e2422);
let _e2427 = global_5.member.member_13.member_9;
let _e2428 = bitcast<i32>(_e2427);
let _e2429 = f32(_e2418);
let _e2431 = (_e2338.member - _e2331.member);
let _e2434 = (((((_e1925.member.x + (_e1925.member_1.x * _e2407)) - _e2331.member) / _e2431) * _e2429) - 0.5f);
let _e2435 = (_e2429 - 1f);
let _e2437 = select(0f, _e2434, (_e2434 > 0f));
let _e2439 = select(_e2435, _e2437, (_e2437 < _e2435));
let _e2440 = f32(_e2423);
let _e2442 = (_e2338.member_1 - _e2331.member_1);
let _e2445 = (((((_e1925.member.y + (_e1925.member_1.y * _e2407)) - _e2331.member_1) / _e2442) * _e2440) - 0.5f);
let _e2446 = (_e2440 - 1f);
let _e2448 = select(0f, _e2445, (_e2445 > 0f));
let _e2450 = select(_e2446, _e2448, (_e2448 < _e2446));
let _e2451 = f32(_e2428);
let _e2453 = (_e2338.member_2 - _e2331.member_2);
let _e2456 = (((((_e1925.member.z + (_e1925.member_1.z * _e2407)) - _e2331.member_2) / _e2453) * _e2451) - 0.5f);
let _e2457 = (_e2451 - 1f);
let _e2459 = select(0f, _e2456, (_e2456 > 0f));
let _e2461 = select(_e2457, _e2459, (_e2459 < _e2457));
let _e2463 = select(0f, _e2439, (_e2439 > 0f));
let _e2465 = select(1e6f, _e2463, (_e2463 < 1e6f));
let _e2472 = select(0i, select(select(i32(_e2465), i32(-2147483648), (_e2465 < -2147483600f)), 2147483647i, (_e2465 > 2147483500f)), (_e2465 == _e2465));
let _e2476 = (_e2472 - select(0i, 1i, (_e2465 < f32(_e2472))));
let _e2478 = select(0f, _e2450, (_e2450 > 0f));
let _e2480 = select(1e6f, _e2478, (_e2478 < 1e6f));
let _e2487 = select(0i, select(select(i32(_e2480), i32(-2147483648), (_e2480 < -2147483600f)), 2147483647i, (_e2480 > 2147483500f)), (_e2480 == _e2480));
let _e2491 = (_e2487 - select(0i, 1i, (_e2480 < f32(_e2487))));
let _e2493 = select(0f, _e2461, (_e2461 > 0f));
let _e2495 = select(1e6f, _e2493, (_e2493 < 1e6f));
let _e2502 = select(0i, select(select(i32(_e2495), i32(-2147483648), (_e2495 < -2147483600f)), 2147483647i, (_e2495 > 2147483500f)), (_e2495 == _e2495));
let _e2506 = (_e2502 - select(0i, 1i, (_e2495 < f32(_e2502))));
let _e2510 = (_e2450 - f32(_e2491));
let _e2512 = (_e2461 - f32(_e2506));
local_10 = (_e2439 - f32(_e2476));
let _e2513 = (_e2476 + 1i);
let _e2515 = select(_e2513, 0i, (_e2513 < 0i));
if (_e2515 >= _e2418) {
phi_5010_ = (_e2418 - 1i);
} else {
phi_5010_ = _e2515;
}
let _e2519 = phi_5010_;
local_11 = (_e2519 - _e2476);
let _e2521 = (_e2491 + 1i);
let _e2523 = select(_e2521, 0i, (_e2521 < 0i));
if (_e2523 >= _e2423) {
phi_5023_ = (_e2423 - 1i);
} else {
phi_5023_ = _e2523;
}
let _e2527 = phi_5023_;
let _e2529 = ((_e2527 - _e2491) * _e2418);
let _e2530 = (_e2506 + 1i);
let _e2532 = select(_e2530, 0i, (_e2530 < 0i));
if (_e2532 >= _e2428) {
phi_5037_ = (_e2428 - 1i);
} else {
phi_5037_ = _e2532;
}
let _e2536 = phi_5037_;
let _e2543 = global_5.member.member_13.member_10;
let _e2544 = bitcast<i32>(_e2543);
let _e2549 = ((_e2544 + (((_e2506 * _e2423) + _e2491) * _e2418)) + _e2476);
let _e2551 = select(_e2002, _e2549, (_e2549 < _e2002));
let _e2556 = global_3.member[bitcast<u32>(select(0i, _e2551, (_e2551 > 0i)))];
let _e2557 = local_10;
let _e2560 = local_11;
let _e2561 = (_e2549 + _e2560);
let _e2563 = select(_e2002, _e2561, (_e2561 < _e2002));
let _e2568 = global_3.member[bitcast<u32>(select(0i, _e2563, (_e2563 > 0i)))];
let _e2569 = local_10;
let _e2572 = (1f - _e2510);
let _e2574 = (_e2549 + _e2529);
let _e2576 = select(_e2002, _e2574, (_e2574 < _e2002));
let _e2581 = global_3.member[bitcast<u32>(select(0i, _e2576, (_e2576 > 0i)))];
let _e2582 = local_10;
let _e2585 = local_11;
let _e2586 = (_e2574 + _e2585);
let _e2588 = select(_e2002, _e2586, (_e2586 < _e2002));
let _e2593 = global_3.member[bitcast<u32>(select(0i, _e2588, (_e2588 > 0i)))];
let _e2594 = local_10;
let _e2599 = (_e2549 + (((_e2536 - _e2506) * _e2418) * _e2423));
let _e2601 = select(_e2002, _e2599, (_e2599 < _e2002));
let _e2606 = global_3.member[bitcast<u32>(select(0i, _e2601, (_e2601 > 0i)))];
let _e2607 = local_10;
let _e2610 = local_11;
let _e2611 = (_e2599 + _e2610);
let _e2613 = select(_e2002, _e2611, (_e2611 < _e2002));
let _e2618 = global_3.member[bitcast<u32>(select(0i, _e2613, (_e2613 > 0i)))];
let _e2619 = local_10;
let _e2623 = (_e2599 + _e2529);
let _e2625 = select(_e2002, _e2623, (_e2623 < _e2002));
let _e2630 = global_3.member[bitcast<u32>(select(0i, _e2625, (_e2625 > 0i)))];
let _e2631 = local_10;
let _e2634 = local_11;
let _e2635 = (_e2623 + _e2634);
let _e2637 = select(_e2002, _e2635, (_e2635 < _e2002));
let _e2642 = global_3.member[bitcast<u32>(select(0i, _e2637, (_e2637 > 0i)))];
let _e2643 = local_10;
let _e2652 = (_e2404 + _e2406);
let _e2662 = (((((_e1925.member.x + (_e1925.member_1.x * _e2652)) - _e2331.member) / _e2431) * _e2429) - 0.5f);
let _e2664 = select(0f, _e2662, (_e2662 > 0f));
let _e2666 = select(_e2435, _e2664, (_e2664 < _e2435));
let _e2670 = (((((_e1925.member.y + (_e1925.member_1.y * _e2652)) - _e2331.member_1) / _e2442) * _e2440) - 0.5f);
let _e2672 = select(0f, _e2670, (_e2670 > 0f));
let _e2674 = select(_e2446, _e2672, (_e2672 < _e2446));
let _e2678 = (((((_e1925.member.z + (_e1925.member_1.z * _e2652)) - _e2331.member_2) / _e2453) * _e2451) - 0.5f);
let _e2680 = select(0f, _e2678, (_e2678 > 0f));
let _e2682 = select(_e2457, _e2680, (_e2680 < _e2457));
let _e2684 = select(0f, _e2666, (_e2666 > 0f));
let _e2686 = select(1e6f, _e2684, (_e2684 < 1e6f));
let _e2693 = select(0i, select(select(i32(_e2686), i32(-2147483648), (_e2686 < -2147483600f)), 2147483647i, (_e2686 > 2147483500f)), (_e2686 == _e2686));
let _e2697 = (_e2693 - select(0i, 1i, (_e2686 < f32(_e2693))));
let _e2699 = select(0f, _e2674, (_e2674 > 0f));
let _e2701 = select(1e6f, _e2699, (_e2699 < 1e6f));
let _e2708 = select(0i, select(select(i32(_e2701), i32(-2147483648), (_e2701 < -2147483600f)), 2147483647i, (_e2701 > 2147483500f)), (_e2701 == _e2701));
let _e2712 = (_e2708 - select(0i, 1i, (_e2701 < f32(_e2708))));
let _e2714 = select(0f, _e2682, (_e2682 > 0f));
let _e2716 = select(1e6f, _e2714, (_e2714 < 1e6f));
let _e2723 = select(0i, select(select(i32(_e2716), i32(-2147483648), (_e2716 < -2147483600f)), 2147483647i, (_e2716 > 2147483500f)), (_e2716 == _e2716));
let _e2727 = (_e2723 - select(0i, 1i, (_e2716 < f32(_e2723))));
let _e2731 = (_e2674 - f32(_e2712));
let _e2733 = (_e2682 - f32(_e2727));
local_8 = (_e2666 - f32(_e2697));
let _e2734 = (_e2697 + 1i);
let _e2736 = select(_e2734, 0i, (_e2734 < 0i));
if (_e2736 >= _e2418) {
phi_5359_ = (_e2418 - 1i);
} else {
phi_5359_ = _e2736;
}
let _e2740 = phi_5359_;
local_9 = (_e2740 - _e2697);
let _e2742 = (_e2712 + 1i);
let _e2744 = select(_e2742, 0i, (_e2742 < 0i));
if (_e2744 >= _e2423) {
phi_5372_ = (_e2423 - 1i);
} else {
phi_5372_ = _e2744;
}
let _e2748 = phi_5372_;
let _e2750 = ((_e2748 - _e2712) * _e2418);
let _e2751 = (_e2727 + 1i);
let _e2753 = select(_e2751, 0i, (_e2751 < 0i));
if (_e2753 >= _e2428) {
phi_5386_ = (_e2428 - 1i);
} else {
phi_5386_ = _e2753;
}
let _e2757 = phi_5386_;
let _e2765 = ((_e2544 + (((_e2727 * _e2423) + _e2712) * _e2418)) + _e2697);
let _e2767 = select(_e2002, _e2765, (_e2765 < _e2002));
let _e2772 = global_3.member[bitcast<u32>(select(0i, _e2767, (_e2767 > 0i)))];
let _e2773 = local_8;
let _e2776 = local_9;
let _e2777 = (_e2765 + _e2776);
let _e2779 = select(_e2002, _e2777, (_e2777 < _e2002));
let _e2784 = global_3.member[bitcast<u32>(select(0i, _e2779, (_e2779 > 0i)))];
let _e2785 = local_8;
let _e2788 = (1f - _e2731);
let _e2790 = (_e2765 + _e2750);
let _e2792 = select(_e2002, _e2790, (_e2790 < _e2002));
let _e2797 = global_3.member[bitcast<u32>(select(0i, _e2792, (_e2792 > 0i)))];
let _e2798 = local_8;
let _e2801 = local_9;
let _e2802 = (_e2790 + _e2801);
let _e2804 = select(_e2002, _e2802, (_e2802 < _e2002));
let _e2809 = global_3.member[bitcast<u32>(select(0i, _e2804, (_e2804 > 0i)))];
let _e2810 = local_8;
let _e2815 = (_e2765 + (((_e2757 - _e2727) * _e2418) * _e2423));
let _e2817 = select(_e2002, _e2815, (_e2815 < _e2002));
let _e2822 = global_3.member[bitcast<u32>(select(0i, _e2817, (_e2817 > 0i)))];
let _e2823 = local_8;
let _e2826 = local_9;
let _e2827 = (_e2815 + _e2826);
let _e2829 = select(_e2002, _e2827, (_e2827 < _e2002));
let _e2834 = global_3.member[bitcast<u32>(select(0i, _e2829, (_e2829 > 0i)))];
let _e2835 = local_8;
let _e2839 = (_e2815 + _e2750);
let _e2841 = select(_e2002, _e2839, (_e2839 < _e2002));
let _e2846 = global_3.member[bitcast<u32>(select(0i, _e2841, (_e2841 > 0i)))];
let _e2847 = local_8;
let _e2850 = local_9;
let _e2851 = (_e2839 + _e2850);
let _e2853 = select(_e2002, _e2851, (_e2851 < _e2002));
let _e2858 = global_3.member[bitcast<u32>(select(0i, _e2853, (_e2853 > 0i)))];
let _e2859 = local_8;
phi_4867_ = (_e2393 + 1u);
phi_4870_ = (_e2395 + ((0.5f * (((((((_e2556 * (1f - _e2557)) + (_e2568 * _e2569)) * _e2572) + (((_e2581 * (1f - _e2582)) + (_e2593 * _e2594)) * _e2510)) * (1f - _e2512)) + (((((_e2606 * (1f - _e2607)) + (_e2618 * _e2619)) * _e2572) + (((_e2630 * (1f - _e2631)) + (_e2642 * _e2643)) * _e2510)) * _e2512)) + ((((((_e2772 * (1f - _e2773)) + (_e2784 * _e2785)) * _e2788) + (((_e2797 * (1f - _e2798)) + (_e2809 * _e2810)) * _e2731)) * (1f - _e2733)) + (((((_e2822 * (1f - _e2823)) + (_e2834 * _e2835)) * _e2788) + (((_e2846 * (1f - _e2847)) + (_e2858 * _e2859)) * _e2731)) * _e2733)))) * _e2405));
} else {
phi_4867_ = u32();
phi_4870_ = f32();
}
let _e2874 = phi_4867_;
let _e2876 = phi_4870_;
continue;
continuing {
phi_4866_ = _e2874;
phi_4869_ = _e2876;
break if !(_e2398);
}
}
let _e10418 = local_69;
phi_5591_ = _e10418;
}
let _e2879 = phi_5591_;
let _e2883 = global_5.member.member_13.member;
let _e2888 = -((_e2883.member * _e2879));
let _e2890 = select(-87f, _e2888, (_e2888 > -87f));
let _e2892 = select(88f, _e2890, (_e2890 < 88f));
let _e2894 = ((_e2892 * 1.442695f) + 0.5f);
let _e2896 = select(-127f, _e2894, (_e2894 > -127f));
let _e2898 = select(128f, _e2896, (_e2896 < 128f));
let _e2905 = select(0i, select(select(i32(_e2898), i32(-2147483648), (_e2898 < -2147483600f)), 2147483647i, (_e2898 > 2147483500f)), (_e2898 == _e2898));
let _e2909 = (_e2905 - select(0i, 1i, (_e2898 < f32(_e2905))));
let _e2910 = f32(_e2909);
let _e2914 = ((_e2892 - (_e2910 * 0.6933594f)) - (_e2910 * -2.1219444e-4f));
let _e2936 = -((_e2883.member_1 * _e2879));
let _e2938 = select(-87f, _e2936, (_e2936 > -87f));
let _e2940 = select(88f, _e2938, (_e2938 < 88f));
let _e2942 = ((_e2940 * 1.442695f) + 0.5f);
let _e2944 = select(-127f, _e2942, (_e2942 > -127f));
let _e2946 = select(128f, _e2944, (_e2944 < 128f));
let _e2953 = select(0i, select(select(i32(_e2946), i32(-2147483648), (_e2946 < -2147483600f)), 2147483647i, (_e2946 > 2147483500f)), (_e2946 == _e2946));
let _e2957 = (_e2953 - select(0i, 1i, (_e2946 < f32(_e2953))));
let _e2958 = f32(_e2957);
let _e2962 = ((_e2940 - (_e2958 * 0.6933594f)) - (_e2958 * -2.1219444e-4f));
let _e2984 = -((_e2883.member_2 * _e2879));
let _e2986 = select(-87f, _e2984, (_e2984 > -87f));
let _e2988 = select(88f, _e2986, (_e2986 < 88f));
let _e2990 = ((_e2988 * 1.442695f) + 0.5f);
let _e2992 = select(-127f, _e2990, (_e2990 > -127f));
let _e2994 = select(128f, _e2992, (_e2992 < 128f));
let _e3001 = select(0i, select(select(i32(_e2994), i32(-2147483648), (_e2994 < -2147483600f)), 2147483647i, (_e2994 > 2147483500f)), (_e2994 == _e2994));
let _e3005 = (_e3001 - select(0i, 1i, (_e2994 < f32(_e3001))));
let _e3006 = f32(_e3005);
let _e3010 = ((_e2988 - (_e3006 * 0.6933594f)) - (_e3006 * -2.1219444e-4f));
let _e3037 = (1f / 3f);
let _e3041 = (_e1925.member_6.x * ((1f + (_e2914 * (1f + (_e2914 * (0.5f + (_e2914 * (0.16666667f + (_e2914 * (0.041666668f + (_e2914 * (0.008333334f + (_e2914 * (0.001388889f + (_e2914 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2909 + 127i)) << bitcast<u32>(23i)))));
let _e3044 = (_e1925.member_6.y * ((1f + (_e2962 * (1f + (_e2962 * (0.5f + (_e2962 * (0.16666667f + (_e2962 * (0.041666668f + (_e2962 * (0.008333334f + (_e2962 * (0.001388889f + (_e2962 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2957 + 127i)) << bitcast<u32>(23i)))));
let _e3047 = (_e1925.member_6.z * ((1f + (_e3010 * (1f + (_e3010 * (0.5f + (_e3010 * (0.16666667f + (_e3010 * (0.041666668f + (_e3010 * (0.008333334f + (_e3010 * (0.001388889f + (_e3010 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3005 + 127i)) << bitcast<u32>(23i)))));
let _e3076 = type_27(_e1925.member, _e1925.member_1, _e1925.member_2, _e1925.member_3, _e1925.member_4, _e1925.member_5, vec3<f32>(_e3041, _e3044, _e3047), _e1925.member_7, _e1925.member_8, _e1925.member_9, _e1925.member_10, _e1925.member_11, _e1925.member_12, _e1925.member_13, _e1925.member_14, _e1925.member_15, _e1925.member_16, _e1925.member_17, _e1925.member_18, _e1925.member_19, _e1925.member_20, _e1925.member_21, _e1925.member_22, _e1925.member_23, _e1925.member_24, _e1925.member_25, _e1925.member_26, _e1925.member_27);
if _e1969 {
phi_5824_ = ((((_e1925.member_6.x + _e1925.member_6.y) + _e1925.member_6.z) * _e3037) - (((_e3041 + _e3044) + _e3047) * _e3037));
} else {
phi_5824_ = 0f;
}
let _e3082 = phi_5824_;
phi_6114_ = type_27(_e3076.member, _e3076.member_1, _e3076.member_2, _e3076.member_3, _e3076.member_4, _e3076.member_5, _e3076.member_6, _e3076.member_7, _e3076.member_8, _e3076.member_9, _e3076.member_10, _e3076.member_11, _e3076.member_12, _e3076.member_13, _e3076.member_14, _e3076.member_15, _e3076.member_16, _e3076.member_17, _e3076.member_18, _e3076.member_19, _e3076.member_20, _e3076.member_21, _e3076.member_22, _e3076.member_23, _e3076.member_24, _e3076.member_25, (_e1925.member_26 + _e3082), _e3076.member_27);
} else {
let _e2042 = select(1e6f, _e1979, (_e1979 < 1e6f));
let _e2044 = local_17;
let _e2045 = (_e2044 * 4i);
let _e2046 = (_e2045 + 1i);
let _e2048 = select(_e2002, _e2046, (_e2046 < _e2002));
let _e2054 = global_3.member[bitcast<u32>(select(0i, _e2048, (_e2048 > 0i)))];
let _e2056 = -((_e2054 * _e2042));
let _e2058 = select(-87f, _e2056, (_e2056 > -87f));
let _e2060 = select(88f, _e2058, (_e2058 < 88f));
let _e2062 = ((_e2060 * 1.442695f) + 0.5f);
let _e2064 = select(-127f, _e2062, (_e2062 > -127f));
let _e2066 = select(128f, _e2064, (_e2064 < 128f));
let _e2073 = select(0i, select(select(i32(_e2066), i32(-2147483648), (_e2066 < -2147483600f)), 2147483647i, (_e2066 > 2147483500f)), (_e2066 == _e2066));
let _e2077 = (_e2073 - select(0i, 1i, (_e2066 < f32(_e2073))));
let _e2078 = f32(_e2077);
let _e2082 = ((_e2060 - (_e2078 * 0.6933594f)) - (_e2078 * -2.1219444e-4f));
let _e2103 = (_e2045 + 2i);
let _e2105 = select(_e2002, _e2103, (_e2103 < _e2002));
let _e2111 = global_3.member[bitcast<u32>(select(0i, _e2105, (_e2105 > 0i)))];
let _e2113 = -((_e2111 * _e2042));
let _e2115 = select(-87f, _e2113, (_e2113 > -87f));
let _e2117 = select(88f, _e2115, (_e2115 < 88f));
let _e2119 = ((_e2117 * 1.442695f) + 0.5f);
let _e2121 = select(-127f, _e2119, (_e2119 > -127f));
let _e2123 = select(128f, _e2121, (_e2121 < 128f));
let _e2130 = select(0i, select(select(i32(_e2123), i32(-2147483648), (_e2123 < -2147483600f)), 2147483647i, (_e2123 > 2147483500f)), (_e2123 == _e2123));
let _e2134 = (_e2130 - select(0i, 1i, (_e2123 < f32(_e2130))));
let _e2135 = f32(_e2134);
let _e2139 = ((_e2117 - (_e2135 * 0.6933594f)) - (_e2135 * -2.1219444e-4f));
let _e2160 = (_e2045 + 3i);
let _e2162 = select(_e2002, _e2160, (_e2160 < _e2002));
let _e2168 = global_3.member[bitcast<u32>(select(0i, _e2162, (_e2162 > 0i)))];
let _e2170 = -((_e2168 * _e2042));
let _e2172 = select(-87f, _e2170, (_e2170 > -87f));
let _e2174 = select(88f, _e2172, (_e2172 < 88f));
let _e2176 = ((_e2174 * 1.442695f) + 0.5f);
let _e2178 = select(-127f, _e2176, (_e2176 > -127f));
let _e2180 = select(128f, _e2178, (_e2178 < 128f));
let _e2187 = select(0i, select(select(i32(_e2180), i32(-2147483648), (_e2180 < -2147483600f)), 2147483647i, (_e2180 > 2147483500f)), (_e2180 == _e2180));
let _e2191 = (_e2187 - select(0i, 1i, (_e2180 < f32(_e2187))));
let _e2192 = f32(_e2191);
let _e2196 = ((_e2174 - (_e2192 * 0.6933594f)) - (_e2192 * -2.1219444e-4f));
let _e2223 = (1f / 3f);
let _e2227 = (_e1925.member_6.x * ((1f + (_e2082 * (1f + (_e2082 * (0.5f + (_e2082 * (0.16666667f + (_e2082 * (0.041666668f + (_e2082 * (0.008333334f + (_e2082 * (0.001388889f + (_e2082 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2077 + 127i)) << bitcast<u32>(23i)))));
let _e2230 = (_e1925.member_6.y * ((1f + (_e2139 * (1f + (_e2139 * (0.5f + (_e2139 * (0.16666667f + (_e2139 * (0.041666668f + (_e2139 * (0.008333334f + (_e2139 * (0.001388889f + (_e2139 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2134 + 127i)) << bitcast<u32>(23i)))));
let _e2233 = (_e1925.member_6.z * ((1f + (_e2196 * (1f + (_e2196 * (0.5f + (_e2196 * (0.16666667f + (_e2196 * (0.041666668f + (_e2196 * (0.008333334f + (_e2196 * (0.001388889f + (_e2196 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2191 + 127i)) << bitcast<u32>(23i)))));
let _e2262 = type_27(_e1925.member, _e1925.member_1, _e1925.member_2, _e1925.member_3, _e1925.member_4, _e1925.member_5, vec3<f32>(_e2227, _e2230, _e2233), _e1925.member_7, _e1925.member_8, _e1925.member_9, _e1925.member_10, _e1925.member_11, _e1925.member_12, _e1925.member_13, _e1925.member_14, _e1925.member_15, _e1925.member_16, _e1925.member_17, _e1925.member_18, _e1925.member_19, _e1925.member_20, _e1925.member_21, _e1925.member_22, _e1925.member_23, _e1925.member_24, _e1925.member_25, _e1925.member_26, _e1925.member_27);
if _e1969 {
phi_6110_ = ((((_e1925.member_6.x + _e1925.member_6.y) + _e1925.member_6.z) * _e2223) - (((_e2227 + _e2230) + _e2233) * _e2223));
} else {
phi_6110_ = 0f;
}
let _e2268 = phi_6110_;
phi_6114_ = type_27(_e2262.member, _e2262.member_1, _e2262.member_2, _e2262.member_3, _e2262.member_4, _e2262.member_5, _e2262.member_6, _e2262.member_7, _e2262.member_8, _e2262.member_9, _e2262.member_10, _e2262.member_11, _e2262.member_12, _e2262.member_13, _e2262.member_14, _e2262.member_15, _e2262.member_16, _e2262.member_17, _e2262.member_18, _e2262.member_19, _e2262.member_20, _e2262.member_21, _e2262.member_22, _e2262.member_23, _e2262.member_24, (_e1925.member_25 + _e2268), _e2262.member_26, _e2262.member_27);
}
let _e3114 = phi_6114_;
if (!(_e1974) || (_e2014 && (_e2012 == 0f))) {
if (bitcast<i32>(countOneBits(bitcast<u32>((_e3114.member_17 & ((1i << bitcast<u32>((_e3114.member_16 & 31i))) - 1i))))) == _e3114.member_20) {
phi_6168_ = (((_e3114.member_6.x + _e3114.member_6.y) + _e3114.member_6.z) * (1f / 3f));
} else {
phi_6168_ = 0f;
}
let _e7322 = phi_6168_;
if (_e3114.member_9 == -1i) {
phi_6180_ = type_27(_e3114.member, _e3114.member_1, _e3114.member_2, _e3114.member_3, _e3114.member_4, _e3114.member_5, _e3114.member_6, _e3114.member_7, _e3114.member_8, _e3114.member_9, _e3114.member_10, _e3114.member_11, _e3114.member_12, _e3114.member_13, _e3114.member_14, _e3114.member_15, _e3114.member_16, _e3114.member_17, _e3114.member_18, _e3114.member_19, _e3114.member_20, _e3114.member_21, _e3114.member_22, (_e3114.member_23 + _e7322), _e3114.member_24, _e3114.member_25, _e3114.member_26, _e3114.member_27);
} else {
phi_6180_ = type_27(_e3114.member, _e3114.member_1, _e3114.member_2, _e3114.member_3, _e3114.member_4, _e3114.member_5, _e3114.member_6, _e3114.member_7, _e3114.member_8, _e3114.member_9, _e3114.member_10, _e3114.member_11, _e3114.member_12, _e3114.member_13, _e3114.member_14, _e3114.member_15, _e3114.member_16, _e3114.member_17, _e3114.member_18, _e3114.member_19, _e3114.member_20, _e3114.member_21, _e3114.member_22, _e3114.member_23, (_e3114.member_24 + _e7322), _e3114.member_25, _e3114.member_26, _e3114.member_27);
}
let _e7386 = phi_6180_;
let _e7388 = (_e7386.member_18 == 0i);
if (_e7388 && (_e7386.member_21 == 0i)) {
phi_8221_ = type_27(_e7386.member, _e7386.member_1, _e7386.member_2, _e7386.member_3, _e7386.member_4, _e7386.member_5, _e7386.member_6, _e7386.member_7, _e7386.member_8, _e7386.member_9, _e7386.member_10, _e7386.member_11, _e7386.member_12, _e7386.member_13, _e7386.member_14, 3f, _e7386.member_16, _e7386.member_17, _e7386.member_18, _e7386.member_19, _e7386.member_20, _e7386.member_21, _e7386.member_22, _e7386.member_23, _e7386.member_24, _e7386.member_25, _e7386.member_26, _e7386.member_27);
} else {
if _e7388 {
let _e7520 = type_27(_e7386.member, _e7386.member_1, _e7386.member_2, _e7386.member_3, _e7386.member_4, _e7386.member_5, _e7386.member_6, _e7386.member_7, _e7386.member_8, _e7386.member_9, _e7386.member_10, _e7386.member_11, _e7386.member_12, _e7386.member_13, _e7386.member_14, _e7386.member_15, _e7386.member_16, _e7386.member_17, _e7386.member_18, _e7386.member_19, (_e7386.member_20 + 1i), _e7386.member_21, _e7386.member_22, _e7386.member_23, _e7386.member_24, _e7386.member_25, _e7386.member_26, _e7386.member_27);
let _e7548 = type_27(_e7520.member, _e7520.member_1, _e7520.member_2, _e7520.member_3, _e7520.member_4, _e7520.member_5, _e7520.member_6, _e7520.member_7, _e7520.member_8, _e7520.member_9, _e7520.member_10, _e7520.member_11, _e7520.member_12, _e7520.member_13, _e7520.member_14, _e7520.member_15, _e7520.member_16, _e7520.member_17, _e7520.member_18, _e7520.member_19, _e7520.member_20, 0i, _e7520.member_22, _e7520.member_23, _e7520.member_24, _e7520.member_25, _e7520.member_26, _e7520.member_27);
let _e7576 = type_27(_e7548.member, _e7548.member_1, _e7548.member_2, _e7548.member_3, _e7548.member_4, _e7548.member_5, _e7548.member_6, _e7548.member_7, _e7548.member_8, _e7548.member_9, _e7548.member_10, _e7548.member_11, _e7548.member_12, _e7548.member_13, _e7548.member_14, _e7548.member_15, _e7548.member_16, 0i, _e7548.member_18, _e7548.member_19, _e7548.member_20, _e7548.member_21, _e7548.member_22, _e7548.member_23, _e7548.member_24, _e7548.member_25, _e7548.member_26, _e7548.member_27);
phi_6221_ = type_27(_e7576.member, _e7576.member_1, _e7576.member_2, _e7576.member_3, _e7576.member_4, _e7576.member_5, _e7576.member_6, _e7576.member_7, _e7576.member_8, _e7576.member_9, _e7576.member_10, _e7576.member_11, _e7576.member_12, _e7576.member_13, _e7576.member_14, _e7576.member_15, _e7576.member_16, _e7576.member_17, _e7576.member_18, 0i, _e7576.member_20, _e7576.member_21, _e7576.member_22, _e7576.member_23, _e7576.member_24, _e7576.member_25, _e7576.member_26, _e7576.member_27);
} else {
let _e7396 = bitcast<i32>((bitcast<u32>(f32(_e7386.member_18)) >> bitcast<u32>(23i)));
let _e7400 = (1i << bitcast<u32>(((_e7396 - 127i) & 31i)));
let _e7401 = (_e7400 - 1i);
let _e7432 = type_27(_e7386.member, _e7386.member_1, _e7386.member_2, _e7386.member_3, _e7386.member_4, _e7386.member_5, _e7386.member_6, _e7386.member_7, _e7386.member_8, _e7386.member_9, _e7386.member_10, _e7386.member_11, _e7386.member_12, _e7386.member_13, _e7386.member_14, _e7386.member_15, _e7386.member_16, ((_e7386.member_17 & _e7401) | _e7400), _e7386.member_18, _e7386.member_19, _e7386.member_20, _e7386.member_21, _e7386.member_22, _e7386.member_23, _e7386.member_24, _e7386.member_25, _e7386.member_26, _e7386.member_27);
let _e7461 = type_27(_e7432.member, _e7432.member_1, _e7432.member_2, _e7432.member_3, _e7432.member_4, _e7432.member_5, _e7432.member_6, _e7432.member_7, _e7432.member_8, _e7432.member_9, _e7432.member_10, _e7432.member_11, _e7432.member_12, _e7432.member_13, _e7432.member_14, _e7432.member_15, _e7432.member_16, _e7432.member_17, (_e7386.member_18 & _e7401), _e7432.member_19, _e7432.member_20, _e7432.member_21, _e7432.member_22, _e7432.member_23, _e7432.member_24, _e7432.member_25, _e7432.member_26, _e7432.member_27);
phi_6221_ = type_27(_e7461.member, _e7461.member_1, _e7461.member_2, _e7461.member_3, _e7461.member_4, _e7461.member_5, _e7461.member_6, _e7461.member_7, _e7461.member_8, _e7461.member_9, _e7461.member_10, _e7461.member_11, _e7461.member_12, _e7461.member_13, _e7461.member_14, _e7461.member_15, _e7461.member_16, _e7461.member_17, _e7461.member_18, (_e7396 + -126i), _e7461.member_20, _e7461.member_21, _e7461.member_22, _e7461.member_23, _e7461.member_24, _e7461.member_25, _e7461.member_26, _e7461.member_27);
}
let _e7606 = phi_6221_;
let _e7612 = global_5.member.member_11.member_2;
let _e7619 = global_5.member.member_11.member_3;
let _e7626 = global_5.member.member_11.member_5;
let _e7632 = global_5.member.member_11.member_7;
let _e7634 = (_e7626 + ((f32(bitcast<i32>(_e139.x)) + 0.5f) * _e7632));
let _e7638 = global_5.member.member_11.member_6;
let _e7644 = global_5.member.member_11.member_8;
let _e7646 = (_e7638 + ((f32(bitcast<i32>(_e139.y)) + 0.5f) * _e7644));
let _e7647 = (_e7612.member * _e7632);
let _e7648 = (_e7612.member_1 * _e7632);
let _e7649 = (_e7612.member_2 * _e7632);
let _e7650 = (_e7619.member * _e7644);
let _e7651 = (_e7619.member_1 * _e7644);
let _e7652 = (_e7619.member_2 * _e7644);
let _e7659 = ((_e7612.member * _e7634) + (_e7619.member * _e7646));
let _e7660 = ((_e7612.member_1 * _e7634) + (_e7619.member_1 * _e7646));
let _e7661 = ((_e7612.member_2 * _e7634) + (_e7619.member_2 * _e7646));
let _e7665 = global_5.member.member_11.member_4;
let _e7672 = global_5.member.member_11.member_1;
let _e7679 = global_5.member.member_10.member;
let _e7680 = (_e7679 == 0u);
let _e7681 = (_e7672.member + _e7659);
let _e7682 = (_e7672.member_1 + _e7660);
let _e7683 = (_e7672.member_2 + _e7661);
let _e7688 = (((_e7681 * _e7681) + (_e7682 * _e7682)) + (_e7683 * _e7683));
let _e7692 = (1f / sqrt(select(0f, _e7688, (_e7688 > 0f))));
let _e7696 = select((_e7681 * _e7692), _e7672.member, _e7680);
let _e7697 = select((_e7682 * _e7692), _e7672.member_1, _e7680);
let _e7698 = select((_e7683 * _e7692), _e7672.member_2, _e7680);
let _e7703 = select(_e7665.member, (_e7665.member + _e7659), _e7680);
let _e7704 = select(_e7665.member_1, (_e7665.member_1 + _e7660), _e7680);
let _e7705 = select(_e7665.member_2, (_e7665.member_2 + _e7661), _e7680);
let _e7719 = (((_e7647 * _e7696) + (_e7648 * _e7697)) + (_e7649 * _e7698));
let _e7729 = select(((_e7647 - (_e7696 * _e7719)) * _e7692), 0f, _e7680);
let _e7730 = select(((_e7648 - (_e7697 * _e7719)) * _e7692), 0f, _e7680);
let _e7731 = select(((_e7649 - (_e7698 * _e7719)) * _e7692), 0f, _e7680);
let _e7737 = (((_e7650 * _e7696) + (_e7651 * _e7697)) + (_e7652 * _e7698));
let _e7747 = select(((_e7650 - (_e7696 * _e7737)) * _e7692), 0f, _e7680);
let _e7748 = select(((_e7651 - (_e7697 * _e7737)) * _e7692), 0f, _e7680);
let _e7749 = select(((_e7652 - (_e7698 * _e7737)) * _e7692), 0f, _e7680);
let _e7758 = (1f / select(_e7696, select(1e-12f, -1e-12f, (_e7696 < 0f)), (bitcast<f32>((bitcast<u32>(_e7696) & 2147483647u)) < 1e-12f)));
let _e7766 = (1f / select(_e7697, select(1e-12f, -1e-12f, (_e7697 < 0f)), (bitcast<f32>((bitcast<u32>(_e7697) & 2147483647u)) < 1e-12f)));
let _e7774 = (1f / select(_e7698, select(1e-12f, -1e-12f, (_e7698 < 0f)), (bitcast<f32>((bitcast<u32>(_e7698) & 2147483647u)) < 1e-12f)));
let _e7777 = global_5.member.member_8;
let _e7783 = global_5.member.member_9;
let _e7788 = ((_e7777.member - _e7703) * _e7758);
let _e7790 = ((_e7783.member - _e7703) * _e7758);
let _e7792 = ((_e7777.member_1 - _e7704) * _e7766);
let _e7794 = ((_e7783.member_1 - _e7704) * _e7766);
let _e7796 = ((_e7777.member_2 - _e7705) * _e7774);
let _e7798 = ((_e7783.member_2 - _e7705) * _e7774);
let _e7800 = select(_e7790, _e7788, (_e7788 < _e7790));
let _e7802 = select(_e7794, _e7792, (_e7792 < _e7794));
let _e7804 = select(_e7802, _e7800, (_e7800 > _e7802));
let _e7806 = select(_e7798, _e7796, (_e7796 < _e7798));
let _e7808 = select(_e7806, _e7804, (_e7804 > _e7806));
let _e7810 = select(_e7790, _e7788, (_e7788 > _e7790));
let _e7812 = select(_e7794, _e7792, (_e7792 > _e7794));
let _e7814 = select(_e7812, _e7810, (_e7810 < _e7812));
let _e7816 = select(_e7798, _e7796, (_e7796 > _e7798));
if (true && _e7680) {
phi_6805_ = -(1e30f);
} else {
phi_6805_ = 0f;
}
let _e7822 = phi_6805_;
let _e7824 = select(_e7822, _e7808, (_e7808 > _e7822));
let _e7826 = ((select(_e7816, _e7814, (_e7814 < _e7816)) <= _e7824) || false);
let _e7827 = select(_e7824, 0f, _e7826);
let _e7828 = (_e7696 * _e7827);
let _e7829 = (_e7697 * _e7827);
let _e7830 = (_e7698 * _e7827);
let _e7831 = (_e7703 + _e7828);
let _e7832 = (_e7704 + _e7829);
let _e7833 = (_e7705 + _e7830);
let _e7863 = type_27((vec3<f32>(_e7703, _e7704, _e7705) + vec3<f32>(_e7828, _e7829, _e7830)), _e7606.member_1, _e7606.member_2, _e7606.member_3, _e7606.member_4, _e7606.member_5, _e7606.member_6, _e7606.member_7, _e7606.member_8, _e7606.member_9, _e7606.member_10, _e7606.member_11, _e7606.member_12, _e7606.member_13, _e7606.member_14, _e7606.member_15, _e7606.member_16, _e7606.member_17, _e7606.member_18, _e7606.member_19, _e7606.member_20, _e7606.member_21, _e7606.member_22, _e7606.member_23, _e7606.member_24, _e7606.member_25, _e7606.member_26, _e7606.member_27);
let _e7891 = type_27(_e7863.member, vec3<f32>(_e7696, _e7697, _e7698), _e7863.member_2, _e7863.member_3, _e7863.member_4, _e7863.member_5, _e7863.member_6, _e7863.member_7, _e7863.member_8, _e7863.member_9, _e7863.member_10, _e7863.member_11, _e7863.member_12, _e7863.member_13, _e7863.member_14, _e7863.member_15, _e7863.member_16, _e7863.member_17, _e7863.member_18, _e7863.member_19, _e7863.member_20, _e7863.member_21, _e7863.member_22, _e7863.member_23, _e7863.member_24, _e7863.member_25, _e7863.member_26, _e7863.member_27);
let _e7929 = type_27(_e7891.member, _e7891.member_1, (vec3<f32>(select(0f, _e7647, _e7680), select(0f, _e7648, _e7680), select(0f, _e7649, _e7680)) + vec3<f32>((_e7729 * _e7827), (_e7730 * _e7827), (_e7731 * _e7827))), _e7891.member_3, _e7891.member_4, _e7891.member_5, _e7891.member_6, _e7891.member_7, _e7891.member_8, _e7891.member_9, _e7891.member_10, _e7891.member_11, _e7891.member_12, _e7891.member_13, _e7891.member_14, _e7891.member_15, _e7891.member_16, _e7891.member_17, _e7891.member_18, _e7891.member_19, _e7891.member_20, _e7891.member_21, _e7891.member_22, _e7891.member_23, _e7891.member_24, _e7891.member_25, _e7891.member_26, _e7891.member_27);
let _e7957 = type_27(_e7929.member, _e7929.member_1, _e7929.member_2, (vec3<f32>(select(0f, _e7650, _e7680), select(0f, _e7651, _e7680), select(0f, _e7652, _e7680)) + vec3<f32>((_e7747 * _e7827), (_e7748 * _e7827), (_e7749 * _e7827))), _e7929.member_4, _e7929.member_5, _e7929.member_6, _e7929.member_7, _e7929.member_8, _e7929.member_9, _e7929.member_10, _e7929.member_11, _e7929.member_12, _e7929.member_13, _e7929.member_14, _e7929.member_15, _e7929.member_16, _e7929.member_17, _e7929.member_18, _e7929.member_19, _e7929.member_20, _e7929.member_21, _e7929.member_22, _e7929.member_23, _e7929.member_24, _e7929.member_25, _e7929.member_26, _e7929.member_27);
let _e7985 = type_27(_e7957.member, _e7957.member_1, _e7957.member_2, _e7957.member_3, vec3<f32>(_e7729, _e7730, _e7731), _e7957.member_5, _e7957.member_6, _e7957.member_7, _e7957.member_8, _e7957.member_9, _e7957.member_10, _e7957.member_11, _e7957.member_12, _e7957.member_13, _e7957.member_14, _e7957.member_15, _e7957.member_16, _e7957.member_17, _e7957.member_18, _e7957.member_19, _e7957.member_20, _e7957.member_21, _e7957.member_22, _e7957.member_23, _e7957.member_24, _e7957.member_25, _e7957.member_26, _e7957.member_27);
let _e8013 = type_27(_e7985.member, _e7985.member_1, _e7985.member_2, _e7985.member_3, _e7985.member_4, vec3<f32>(_e7747, _e7748, _e7749), _e7985.member_6, _e7985.member_7, _e7985.member_8, _e7985.member_9, _e7985.member_10, _e7985.member_11, _e7985.member_12, _e7985.member_13, _e7985.member_14, _e7985.member_15, _e7985.member_16, _e7985.member_17, _e7985.member_18, _e7985.member_19, _e7985.member_20, _e7985.member_21, _e7985.member_22, _e7985.member_23, _e7985.member_24, _e7985.member_25, _e7985.member_26, _e7985.member_27);
let _e8041 = type_27(_e8013.member, _e8013.member_1, _e8013.member_2, _e8013.member_3, _e8013.member_4, _e8013.member_5, _e8013.member_6, 0i, _e8013.member_8, _e8013.member_9, _e8013.member_10, _e8013.member_11, _e8013.member_12, _e8013.member_13, _e8013.member_14, _e8013.member_15, _e8013.member_16, _e8013.member_17, _e8013.member_18, _e8013.member_19, _e8013.member_20, _e8013.member_21, _e8013.member_22, _e8013.member_23, _e8013.member_24, _e8013.member_25, _e8013.member_26, _e8013.member_27);
let _e8069 = type_27(_e8041.member, _e8041.member_1, _e8041.member_2, _e8041.member_3, _e8041.member_4, _e8041.member_5, _e8041.member_6, _e8041.member_7, _e8041.member_8, _e8041.member_9, _e8041.member_10, _e8041.member_11, _e8041.member_12, _e8041.member_13, _e8041.member_14, _e8041.member_15, 0i, _e8041.member_17, _e8041.member_18, _e8041.member_19, _e8041.member_20, _e8041.member_21, _e8041.member_22, _e8041.member_23, _e8041.member_24, _e8041.member_25, _e8041.member_26, _e8041.member_27);
let _e8097 = type_27(_e8069.member, _e8069.member_1, _e8069.member_2, _e8069.member_3, _e8069.member_4, _e8069.member_5, _e8069.member_6, _e8069.member_7, _e8069.member_8, _e8069.member_9, _e8069.member_10, _e8069.member_11, _e8069.member_12, _e8069.member_13, _e8069.member_14, 1f, _e8069.member_16, _e8069.member_17, _e8069.member_18, _e8069.member_19, _e8069.member_20, _e8069.member_21, _e8069.member_22, _e8069.member_23, _e8069.member_24, _e8069.member_25, _e8069.member_26, _e8069.member_27);
let _e8125 = type_27(_e8097.member, _e8097.member_1, _e8097.member_2, _e8097.member_3, _e8097.member_4, _e8097.member_5, _e8097.member_6, _e8097.member_7, _e8097.member_8, _e8097.member_9, _e8097.member_10, _e8097.member_11, _e8097.member_12, 0f, _e8097.member_14, _e8097.member_15, _e8097.member_16, _e8097.member_17, _e8097.member_18, _e8097.member_19, _e8097.member_20, _e8097.member_21, _e8097.member_22, _e8097.member_23, _e8097.member_24, _e8097.member_25, _e8097.member_26, _e8097.member_27);
let _e8153 = type_27(_e8125.member, _e8125.member_1, _e8125.member_2, _e8125.member_3, _e8125.member_4, _e8125.member_5, _e8125.member_6, _e8125.member_7, _e8125.member_8, _e8125.member_9, _e8125.member_10, 0i, _e8125.member_12, _e8125.member_13, _e8125.member_14, _e8125.member_15, _e8125.member_16, _e8125.member_17, _e8125.member_18, _e8125.member_19, _e8125.member_20, _e8125.member_21, _e8125.member_22, _e8125.member_23, _e8125.member_24, _e8125.member_25, _e8125.member_26, _e8125.member_27);
let _e8181 = type_27(_e8153.member, _e8153.member_1, _e8153.member_2, _e8153.member_3, _e8153.member_4, _e8153.member_5, _e8153.member_6, _e8153.member_7, _e8153.member_8, _e8153.member_9, _e8153.member_10, _e8153.member_11, 0i, _e8153.member_13, _e8153.member_14, _e8153.member_15, _e8153.member_16, _e8153.member_17, _e8153.member_18, _e8153.member_19, _e8153.member_20, _e8153.member_21, _e8153.member_22, _e8153.member_23, _e8153.member_24, _e8153.member_25, _e8153.member_26, _e8153.member_27);
let _e8186 = global_5.member.member_14.member.member;
let _e8197 = ((((_e8186.member.member * _e7831) + (_e8186.member.member_1 * _e7832)) + (_e8186.member.member_2 * _e7833)) + _e8186.member_1);
let _e8203 = -((((_e8186.member.member * _e7696) + (_e8186.member.member_1 * _e7697)) + (_e8186.member.member_2 * _e7698)));
let _e8205 = (_e8203 > 1e-9f);
let _e8209 = ((_e8197 / select(1e-9f, _e8203, _e8205)) - 0.015625f);
let _e8212 = select(1e30f, select(0f, _e8209, (_e8209 > 0f)), ((_e8197 > 0f) && _e8205));
let _e8217 = global_5.member.member_14.member_1.member;
let _e8228 = ((((_e8217.member.member * _e7831) + (_e8217.member.member_1 * _e7832)) + (_e8217.member.member_2 * _e7833)) + _e8217.member_1);
let _e8234 = -((((_e8217.member.member * _e7696) + (_e8217.member.member_1 * _e7697)) + (_e8217.member.member_2 * _e7698)));
let _e8236 = (_e8234 > 1e-9f);
let _e8240 = ((_e8228 / select(1e-9f, _e8234, _e8236)) - 0.015625f);
let _e8243 = select(1e30f, select(0f, _e8240, (_e8240 > 0f)), ((_e8228 > 0f) && _e8236));
let _e8247 = (_e8243 < _e8212);
let _e8278 = type_27(_e8181.member, _e8181.member_1, _e8181.member_2, _e8181.member_3, _e8181.member_4, _e8181.member_5, _e8181.member_6, _e8181.member_7, 0i, _e8181.member_9, _e8181.member_10, _e8181.member_11, _e8181.member_12, _e8181.member_13, _e8181.member_14, _e8181.member_15, _e8181.member_16, _e8181.member_17, _e8181.member_18, _e8181.member_19, _e8181.member_20, _e8181.member_21, _e8181.member_22, _e8181.member_23, _e8181.member_24, _e8181.member_25, _e8181.member_26, _e8181.member_27);
let _e8306 = type_27(_e8278.member, _e8278.member_1, _e8278.member_2, _e8278.member_3, _e8278.member_4, _e8278.member_5, _e8278.member_6, _e8278.member_7, _e8278.member_8, select(select(-2i, -3i, _e8247), -1i, ((_e8212 >= 1e30f) && (_e8243 >= 1e30f))), _e8278.member_10, _e8278.member_11, _e8278.member_12, _e8278.member_13, _e8278.member_14, _e8278.member_15, _e8278.member_16, _e8278.member_17, _e8278.member_18, _e8278.member_19, _e8278.member_20, _e8278.member_21, _e8278.member_22, _e8278.member_23, _e8278.member_24, _e8278.member_25, _e8278.member_26, _e8278.member_27);
let _e8334 = type_27(_e8306.member, _e8306.member_1, _e8306.member_2, _e8306.member_3, _e8306.member_4, _e8306.member_5, _e8306.member_6, _e8306.member_7, _e8306.member_8, _e8306.member_9, select(_e8212, _e8243, _e8247), _e8306.member_11, _e8306.member_12, _e8306.member_13, _e8306.member_14, _e8306.member_15, _e8306.member_16, _e8306.member_17, _e8306.member_18, _e8306.member_19, _e8306.member_20, _e8306.member_21, _e8306.member_22, _e8306.member_23, _e8306.member_24, _e8306.member_25, _e8306.member_26, _e8306.member_27);
let _e8338 = global_5.member.member_13.member_4;
let _e8345 = global_5.member.member_13.member_5;
let _e8350 = ((_e8338.member - _e7703) * _e7758);
let _e8352 = ((_e8345.member - _e7703) * _e7758);
let _e8354 = ((_e8338.member_1 - _e7704) * _e7766);
let _e8356 = ((_e8345.member_1 - _e7704) * _e7766);
let _e8358 = ((_e8338.member_2 - _e7705) * _e7774);
let _e8360 = ((_e8345.member_2 - _e7705) * _e7774);
let _e8362 = select(_e8352, _e8350, (_e8350 < _e8352));
let _e8364 = select(_e8356, _e8354, (_e8354 < _e8356));
let _e8366 = select(_e8364, _e8362, (_e8362 > _e8364));
let _e8368 = select(_e8360, _e8358, (_e8358 < _e8360));
let _e8370 = select(_e8368, _e8366, (_e8366 > _e8368));
let _e8372 = select(_e8352, _e8350, (_e8350 > _e8352));
let _e8374 = select(_e8356, _e8354, (_e8354 > _e8356));
let _e8376 = select(_e8374, _e8372, (_e8372 < _e8374));
let _e8378 = select(_e8360, _e8358, (_e8358 > _e8360));
let _e8380 = select(_e8378, _e8376, (_e8376 < _e8378));
let _e8382 = select(_e7822, _e8370, (_e8370 > _e7822));
let _e8384 = select(_e7827, _e8380, (_e8380 < _e7827));
let _e8385 = (_e8384 > _e8382);
let _e8386 = select(_e7822, _e8382, _e8385);
let _e8388 = (select(_e7822, _e8384, _e8385) - _e8386);
let _e8392 = global_5.member.member_13.member_6;
if (_e8392 == 0u) {
phi_7965_ = _e8388;
} else {
let _e8395 = (_e8388 / f32(_e8392));
phi_7240_ = 0u;
phi_7243_ = 0f;
loop {
let _e8397 = phi_7240_;
let _e8399 = phi_7243_;
local_71 = _e8399;
let _e8402 = ((_e8397 < _e8392) && (_e8388 > 0f));
if _e8402 {
let _e8405 = (_e8386 + (_e8395 * f32(_e8397)));
let _e8406 = (_e8405 + _e8395);
let _e8408 = (0.5f * (_e8405 + _e8406));
let _e8409 = (_e8406 - _e8405);
let _e8410 = (0.28867513f * _e8409);
let _e8411 = (_e8408 - _e8410);
let _e8421 = global_5.member.member_13.member_7;
let _e8422 = bitcast<i32>(_e8421);
let _e8426 = global_5.member.member_13.member_8;
let _e8427 = bitcast<i32>(_e8426);
let _e8431 = global_5.member.member_13.member_9;
let _e8432 = bitcast<i32>(_e8431);
let _e8433 = f32(_e8422);
let _e8435 = (_e8345.member - _e8338.member);
let _e8438 = (((((_e7703 + (_e7696 * _e8411)) - _e8338.member) / _e8435) * _e8433) - 0.5f);
let _e8439 = (_e8433 - 1f);
let _e8441 = select(0f, _e8438, (_e8438 > 0f));
let _e8443 = select(_e8439, _e8441, (_e8441 < _e8439));
let _e8444 = f32(_e8427);
let _e8446 = (_e8345.member_1 - _e8338.member_1);
let _e8449 = (((((_e7704 + (_e7697 * _e8411)) - _e8338.member_1) / _e8446) * _e8444) - 0.5f);
let _e8450 = (_e8444 - 1f);
let _e8452 = select(0f, _e8449, (_e8449 > 0f));
let _e8454 = select(_e8450, _e8452, (_e8452 < _e8450));
let _e8455 = f32(_e8432);
let _e8457 = (_e8345.member_2 - _e8338.member_2);
let _e8460 = (((((_e7705 + (_e7698 * _e8411)) - _e8338.member_2) / _e8457) * _e8455) - 0.5f);
let _e8461 = (_e8455 - 1f);
let _e8463 = select(0f, _e8460, (_e8460 > 0f));
let _e8465 = select(_e8461, _e8463, (_e8463 < _e8461));
let _e8467 = select(0f, _e8443, (_e8443 > 0f));
let _e8469 = select(1e6f, _e8467, (_e8467 < 1e6f));
let _e8476 = select(0i, select(select(i32(_e8469), i32(-2147483648), (_e8469 < -2147483600f)), 2147483647i, (_e8469 > 2147483500f)), (_e8469 == _e8469));
let _e8480 = (_e8476 - select(0i, 1i, (_e8469 < f32(_e8476))));
let _e8482 = select(0f, _e8454, (_e8454 > 0f));
let _e8484 = select(1e6f, _e8482, (_e8482 < 1e6f));
let _e8491 = select(0i, select(select(i32(_e8484), i32(-2147483648), (_e8484 < -2147483600f)), 2147483647i, (_e8484 > 2147483500f)), (_e8484 == _e8484));
let _e8495 = (_e8491 - select(0i, 1i, (_e8484 < f32(_e8491))));
let _e8497 = select(0f, _e8465, (_e8465 > 0f));
let _e8499 = select(1e6f, _e8497, (_e8497 < 1e6f));
let _e8506 = select(0i, select(select(i32(_e8499), i32(-2147483648), (_e8499 < -2147483600f)), 2147483647i, (_e8499 > 2147483500f)), (_e8499 == _e8499));
let _e8510 = (_e8506 - select(0i, 1i, (_e8499 < f32(_e8506))));
let _e8514 = (_e8454 - f32(_e8495));
let _e8516 = (_e8465 - f32(_e8510));
local_6 = (_e8443 - f32(_e8480));
let _e8517 = (_e8480 + 1i);
let _e8519 = select(_e8517, 0i, (_e8517 < 0i));
if (_e8519 >= _e8422) {
phi_7384_ = (_e8422 - 1i);
} else {
phi_7384_ = _e8519;
}
let _e8523 = phi_7384_;
local_7 = (_e8523 - _e8480);
let _e8525 = (_e8495 + 1i);
let _e8527 = select(_e8525, 0i, (_e8525 < 0i));
if (_e8527 >= _e8427) {
phi_7397_ = (_e8427 - 1i);
} else {
phi_7397_ = _e8527;
}
let _e8531 = phi_7397_;
let _e8533 = ((_e8531 - _e8495) * _e8422);
let _e8534 = (_e8510 + 1i);
let _e8536 = select(_e8534, 0i, (_e8534 < 0i));
if (_e8536 >= _e8432) {
phi_7411_ = (_e8432 - 1i);
} else {
phi_7411_ = _e8536;
}
let _e8540 = phi_7411_;
let _e8547 = global_5.member.member_13.member_10;
let _e8548 = bitcast<i32>(_e8547);
let _e8553 = ((_e8548 + (((_e8510 * _e8427) + _e8495) * _e8422)) + _e8480);
let _e8555 = select(_e2002, _e8553, (_e8553 < _e2002));
let _e8560 = global_3.member[bitcast<u32>(select(0i, _e8555, (_e8555 > 0i)))];
let _e8561 = local_6;
let _e8564 = local_7;
let _e8565 = (_e8553 + _e8564);
let _e8567 = select(_e2002, _e8565, (_e8565 < _e2002));
let _e8572 = global_3.member[bitcast<u32>(select(0i, _e8567, (_e8567 > 0i)))];
let _e8573 = local_6;
let _e8576 = (1f - _e8514);
let _e8578 = (_e8553 + _e8533);
let _e8580 = select(_e2002, _e8578, (_e8578 < _e2002));
let _e8585 = global_3.member[bitcast<u32>(select(0i, _e8580, (_e8580 > 0i)))];
let _e8586 = local_6;
let _e8589 = local_7;
let _e8590 = (_e8578 + _e8589);
let _e8592 = select(_e2002, _e8590, (_e8590 < _e2002));
let _e8597 = global_3.member[bitcast<u32>(select(0i, _e8592, (_e8592 > 0i)))];
let _e8598 = local_6;
let _e8603 = (_e8553 + (((_e8540 - _e8510) * _e8422) * _e8427));
let _e8605 = select(_e2002, _e8603, (_e8603 < _e2002));
let _e8610 = global_3.member[bitcast<u32>(select(0i, _e8605, (_e8605 > 0i)))];
let _e8611 = local_6;
let _e8614 = local_7;
let _e8615 = (_e8603 + _e8614);
let _e8617 = select(_e2002, _e8615, (_e8615 < _e2002));
let _e8622 = global_3.member[bitcast<u32>(select(0i, _e8617, (_e8617 > 0i)))];
let _e8623 = local_6;
let _e8627 = (_e8603 + _e8533);
let _e8629 = select(_e2002, _e8627, (_e8627 < _e2002));
let _e8634 = global_3.member[bitcast<u32>(select(0i, _e8629, (_e8629 > 0i)))];
let _e8635 = local_6;
let _e8638 = local_7;
let _e8639 = (_e8627 + _e8638);
let _e8641 = select(_e2002, _e8639, (_e8639 < _e2002));
let _e8646 = global_3.member[bitcast<u32>(select(0i, _e8641, (_e8641 > 0i)))];
let _e8647 = local_6;
let _e8656 = (_e8408 + _e8410);
let _e8666 = (((((_e7703 + (_e7696 * _e8656)) - _e8338.member) / _e8435) * _e8433) - 0.5f);
let _e8668 = select(0f, _e8666, (_e8666 > 0f));
let _e8670 = select(_e8439, _e8668, (_e8668 < _e8439));
let _e8674 = (((((_e7704 + (_e7697 * _e8656)) - _e8338.member_1) / _e8446) * _e8444) - 0.5f);
let _e8676 = select(0f, _e8674, (_e8674 > 0f));
let _e8678 = select(_e8450, _e8676, (_e8676 < _e8450));
let _e8682 = (((((_e7705 + (_e7698 * _e8656)) - _e8338.member_2) / _e8457) * _e8455) - 0.5f);
let _e8684 = select(0f, _e8682, (_e8682 > 0f));
let _e8686 = select(_e8461, _e8684, (_e8684 < _e8461));
let _e8688 = select(0f, _e8670, (_e8670 > 0f));
let _e8690 = select(1e6f, _e8688, (_e8688 < 1e6f));
let _e8697 = select(0i, select(select(i32(_e8690), i32(-2147483648), (_e8690 < -2147483600f)), 2147483647i, (_e8690 > 2147483500f)), (_e8690 == _e8690));
let _e8701 = (_e8697 - select(0i, 1i, (_e8690 < f32(_e8697))));
let _e8703 = select(0f, _e8678, (_e8678 > 0f));
let _e8705 = select(1e6f, _e8703, (_e8703 < 1e6f));
let _e8712 = select(0i, select(select(i32(_e8705), i32(-2147483648), (_e8705 < -2147483600f)), 2147483647i, (_e8705 > 2147483500f)), (_e8705 == _e8705));
let _e8716 = (_e8712 - select(0i, 1i, (_e8705 < f32(_e8712))));
let _e8718 = select(0f, _e8686, (_e8686 > 0f));
let _e8720 = select(1e6f, _e8718, (_e8718 < 1e6f));
let _e8727 = select(0i, select(select(i32(_e8720), i32(-2147483648), (_e8720 < -2147483600f)), 2147483647i, (_e8720 > 2147483500f)), (_e8720 == _e8720));
let _e8731 = (_e8727 - select(0i, 1i, (_e8720 < f32(_e8727))));
let _e8735 = (_e8678 - f32(_e8716));
let _e8737 = (_e8686 - f32(_e8731));
local_4 = (_e8670 - f32(_e8701));
let _e8738 = (_e8701 + 1i);
let _e8740 = select(_e8738, 0i, (_e8738 < 0i));
if (_e8740 >= _e8422) {
phi_7733_ = (_e8422 - 1i);
} else {
phi_7733_ = _e8740;
}
let _e8744 = phi_7733_;
local_5 = (_e8744 - _e8701);
let _e8746 = (_e8716 + 1i);
let _e8748 = select(_e8746, 0i, (_e8746 < 0i));
if (_e8748 >= _e8427) {
phi_7746_ = (_e8427 - 1i);
} else {
phi_7746_ = _e8748;
}
let _e8752 = phi_7746_;
let _e8754 = ((_e8752 - _e8716) * _e8422);
let _e8755 = (_e8731 + 1i);
let _e8757 = select(_e8755, 0i, (_e8755 < 0i));
if (_e8757 >= _e8432) {
phi_7760_ = (_e8432 - 1i);
} else {
phi_7760_ = _e8757;
}
let _e8761 = phi_7760_;
let _e8769 = ((_e8548 + (((_e8731 * _e8427) + _e8716) * _e8422)) + _e8701);
let _e8771 = select(_e2002, _e8769, (_e8769 < _e2002));
let _e8776 = global_3.member[bitcast<u32>(select(0i, _e8771, (_e8771 > 0i)))];
let _e8777 = local_4;
let _e8780 = local_5;
let _e8781 = (_e8769 + _e8780);
let _e8783 = select(_e2002, _e8781, (_e8781 < _e2002));
let _e8788 = global_3.member[bitcast<u32>(select(0i, _e8783, (_e8783 > 0i)))];
let _e8789 = local_4;
let _e8792 = (1f - _e8735);
let _e8794 = (_e8769 + _e8754);
let _e8796 = select(_e2002, _e8794, (_e8794 < _e2002));
let _e8801 = global_3.member[bitcast<u32>(select(0i, _e8796, (_e8796 > 0i)))];
let _e8802 = local_4;
let _e8805 = local_5;
let _e8806 = (_e8794 + _e8805);
let _e8808 = select(_e2002, _e8806, (_e8806 < _e2002));
let _e8813 = global_3.member[bitcast<u32>(select(0i, _e8808, (_e8808 > 0i)))];
let _e8814 = local_4;
let _e8819 = (_e8769 + (((_e8761 - _e8731) * _e8422) * _e8427));
let _e8821 = select(_e2002, _e8819, (_e8819 < _e2002));
let _e8826 = global_3.member[bitcast<u32>(select(0i, _e8821, (_e8821 > 0i)))];
let _e8827 = local_4;
let _e8830 = local_5;
let _e8831 = (_e8819 + _e8830);
let _e8833 = select(_e2002, _e8831, (_e8831 < _e2002));
let _e8838 = global_3.member[bitcast<u32>(select(0i, _e8833, (_e8833 > 0i)))];
let _e8839 = local_4;
let _e8843 = (_e8819 + _e8754);
let _e8845 = select(_e2002, _e8843, (_e8843 < _e2002));
let _e8850 = global_3.member[bitcast<u32>(select(0i, _e8845, (_e8845 > 0i)))];
let _e8851 = local_4;
let _e8854 = local_5;
let _e8855 = (_e8843 + _e8854);
let _e8857 = select(_e2002, _e8855, (_e8855 < _e2002));
let _e8862 = global_3.member[bitcast<u32>(select(0i, _e8857, (_e8857 > 0i)))];
let _e8863 = local_4;
phi_7241_ = (_e8397 + 1u);
phi_7244_ = (_e8399 + ((0.5f * (((((((_e8560 * (1f - _e8561)) + (_e8572 * _e8573)) * _e8576) + (((_e8585 * (1f - _e8586)) + (_e8597 * _e8598)) * _e8514)) * (1f - _e8516)) + (((((_e8610 * (1f - _e8611)) + (_e8622 * _e8623)) * _e8576) + (((_e8634 * (1f - _e8635)) + (_e8646 * _e8647)) * _e8514)) * _e8516)) + ((((((_e8776 * (1f - _e8777)) + (_e8788 * _e8789)) * _e8792) + (((_e8801 * (1f - _e8802)) + (_e8813 * _e8814)) * _e8735)) * (1f - _e8737)) + (((((_e8826 * (1f - _e8827)) + (_e8838 * _e8839)) * _e8792) + (((_e8850 * (1f - _e8851)) + (_e8862 * _e8863)) * _e8735)) * _e8737)))) * _e8409));
} else {
phi_7241_ = u32();
phi_7244_ = f32();
}
let _e8878 = phi_7241_;
let _e8880 = phi_7244_;
continue;
continuing {
phi_7240_ = _e8878;
phi_7243_ = _e8880;
break if !(_e8402);
}
}
let _e10479 = local_71;
phi_7965_ = _e10479;
}
let _e8883 = phi_7965_;
let _e8887 = global_5.member.member_13.member;
let _e8892 = -((_e8887.member * _e8883));
let _e8894 = select(-87f, _e8892, (_e8892 > -87f));
let _e8896 = select(88f, _e8894, (_e8894 < 88f));
let _e8898 = ((_e8896 * 1.442695f) + 0.5f);
let _e8900 = select(-127f, _e8898, (_e8898 > -127f));
let _e8902 = select(128f, _e8900, (_e8900 < 128f));
let _e8909 = select(0i, select(select(i32(_e8902), i32(-2147483648), (_e8902 < -2147483600f)), 2147483647i, (_e8902 > 2147483500f)), (_e8902 == _e8902));
let _e8913 = (_e8909 - select(0i, 1i, (_e8902 < f32(_e8909))));
let _e8914 = f32(_e8913);
let _e8918 = ((_e8896 - (_e8914 * 0.6933594f)) - (_e8914 * -2.1219444e-4f));
let _e8940 = -((_e8887.member_1 * _e8883));
let _e8942 = select(-87f, _e8940, (_e8940 > -87f));
let _e8944 = select(88f, _e8942, (_e8942 < 88f));
let _e8946 = ((_e8944 * 1.442695f) + 0.5f);
let _e8948 = select(-127f, _e8946, (_e8946 > -127f));
let _e8950 = select(128f, _e8948, (_e8948 < 128f));
let _e8957 = select(0i, select(select(i32(_e8950), i32(-2147483648), (_e8950 < -2147483600f)), 2147483647i, (_e8950 > 2147483500f)), (_e8950 == _e8950));
let _e8961 = (_e8957 - select(0i, 1i, (_e8950 < f32(_e8957))));
let _e8962 = f32(_e8961);
let _e8966 = ((_e8944 - (_e8962 * 0.6933594f)) - (_e8962 * -2.1219444e-4f));
let _e8988 = -((_e8887.member_2 * _e8883));
let _e8990 = select(-87f, _e8988, (_e8988 > -87f));
let _e8992 = select(88f, _e8990, (_e8990 < 88f));
let _e8994 = ((_e8992 * 1.442695f) + 0.5f);
let _e8996 = select(-127f, _e8994, (_e8994 > -127f));
let _e8998 = select(128f, _e8996, (_e8996 < 128f));
let _e9005 = select(0i, select(select(i32(_e8998), i32(-2147483648), (_e8998 < -2147483600f)), 2147483647i, (_e8998 > 2147483500f)), (_e8998 == _e8998));
let _e9009 = (_e9005 - select(0i, 1i, (_e8998 < f32(_e9005))));
let _e9010 = f32(_e9009);
let _e9014 = ((_e8992 - (_e9010 * 0.6933594f)) - (_e9010 * -2.1219444e-4f));
let _e9037 = (1f / 3f);
let _e9039 = (1f * ((1f + (_e8918 * (1f + (_e8918 * (0.5f + (_e8918 * (0.16666667f + (_e8918 * (0.041666668f + (_e8918 * (0.008333334f + (_e8918 * (0.001388889f + (_e8918 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e8913 + 127i)) << bitcast<u32>(23i)))));
let _e9040 = (1f * ((1f + (_e8966 * (1f + (_e8966 * (0.5f + (_e8966 * (0.16666667f + (_e8966 * (0.041666668f + (_e8966 * (0.008333334f + (_e8966 * (0.001388889f + (_e8966 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e8961 + 127i)) << bitcast<u32>(23i)))));
let _e9041 = (1f * ((1f + (_e9014 * (1f + (_e9014 * (0.5f + (_e9014 * (0.16666667f + (_e9014 * (0.041666668f + (_e9014 * (0.008333334f + (_e9014 * (0.001388889f + (_e9014 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9009 + 127i)) << bitcast<u32>(23i)))));
let _e9070 = type_27(_e8334.member, _e8334.member_1, _e8334.member_2, _e8334.member_3, _e8334.member_4, _e8334.member_5, vec3<f32>(_e9039, _e9040, _e9041), _e8334.member_7, _e8334.member_8, _e8334.member_9, _e8334.member_10, _e8334.member_11, _e8334.member_12, _e8334.member_13, _e8334.member_14, _e8334.member_15, _e8334.member_16, _e8334.member_17, _e8334.member_18, _e8334.member_19, _e8334.member_20, _e8334.member_21, _e8334.member_22, _e8334.member_23, _e8334.member_24, _e8334.member_25, _e8334.member_26, _e8334.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e7606.member_20) {
phi_8193_ = ((((1f + 1f) + 1f) * _e9037) - (((_e9039 + _e9040) + _e9041) * _e9037));
} else {
phi_8193_ = 0f;
}
let _e9080 = phi_8193_;
let _e9110 = type_27(_e9070.member, _e9070.member_1, _e9070.member_2, _e9070.member_3, _e9070.member_4, _e9070.member_5, _e9070.member_6, _e9070.member_7, _e9070.member_8, _e9070.member_9, _e9070.member_10, _e9070.member_11, _e9070.member_12, _e9070.member_13, _e9070.member_14, _e9070.member_15, _e9070.member_16, _e9070.member_17, _e9070.member_18, _e9070.member_19, _e9070.member_20, _e9070.member_21, _e9070.member_22, _e9070.member_23, _e9070.member_24, _e9070.member_25, (_e7606.member_26 + _e9080), _e9070.member_27);
if _e7826 {
let _e9138 = type_27(_e9110.member, _e9110.member_1, _e9110.member_2, _e9110.member_3, _e9110.member_4, _e9110.member_5, _e9110.member_6, _e9110.member_7, _e1891, _e9110.member_9, _e9110.member_10, _e9110.member_11, _e9110.member_12, _e9110.member_13, _e9110.member_14, _e9110.member_15, _e9110.member_16, _e9110.member_17, _e9110.member_18, _e9110.member_19, _e9110.member_20, _e9110.member_21, _e9110.member_22, _e9110.member_23, _e9110.member_24, _e9110.member_25, _e9110.member_26, _e9110.member_27);
phi_8220_ = type_27(_e9138.member, _e9138.member_1, _e9138.member_2, _e9138.member_3, _e9138.member_4, _e9138.member_5, _e9138.member_6, _e9138.member_7, _e9138.member_8, _e9138.member_9, _e9138.member_10, _e9138.member_11, _e9138.member_12, _e9138.member_13, _e9138.member_14, 3f, _e9138.member_16, _e9138.member_17, _e9138.member_18, _e9138.member_19, _e9138.member_20, _e9138.member_21, _e9138.member_22, _e9138.member_23, _e9138.member_24, _e9138.member_25, _e9138.member_26, _e9138.member_27);
} else {
phi_8220_ = _e9110;
}
let _e9168 = phi_8220_;
phi_8221_ = _e9168;
}
let _e9198 = phi_8221_;
phi_12415_ = _e9198;
phi_12416_ = type_27();
phi_12417_ = true;
} else {
let _e3121 = local_18;
let _e3123 = local_19;
let _e3125 = (!(_e2014) && (_e3121 == _e3123));
if _e3125 {
let _e7048 = type_27(_e3114.member, _e3114.member_1, _e3114.member_2, _e3114.member_3, _e3114.member_4, _e3114.member_5, _e3114.member_6, _e2023, _e3114.member_8, _e3114.member_9, _e3114.member_10, _e3114.member_11, _e3114.member_12, _e3114.member_13, _e3114.member_14, _e3114.member_15, _e3114.member_16, _e3114.member_17, _e3114.member_18, _e3114.member_19, _e3114.member_20, _e3114.member_21, _e3114.member_22, _e3114.member_23, _e3114.member_24, _e3114.member_25, _e3114.member_26, _e3114.member_27);
let _e7079 = type_27(_e7048.member, _e7048.member_1, _e7048.member_2, _e7048.member_3, _e7048.member_4, _e7048.member_5, _e7048.member_6, _e7048.member_7, _e7048.member_8, _e7048.member_9, _e7048.member_10, _e7048.member_11, _e7048.member_12, select(1.1754944e-38f, _e3114.member_14, (_e3114.member_14 > 1.1754944e-38f)), _e7048.member_14, _e7048.member_15, _e7048.member_16, _e7048.member_17, _e7048.member_18, _e7048.member_19, _e7048.member_20, _e7048.member_21, _e7048.member_22, _e7048.member_23, _e7048.member_24, _e7048.member_25, _e7048.member_26, _e7048.member_27);
let _e7107 = type_27(_e7079.member, _e7079.member_1, _e7079.member_2, _e7079.member_3, _e7079.member_4, _e7079.member_5, _e7079.member_6, _e7079.member_7, _e7079.member_8, _e7079.member_9, _e7079.member_10, 0i, _e7079.member_12, _e7079.member_13, _e7079.member_14, _e7079.member_15, _e7079.member_16, _e7079.member_17, _e7079.member_18, _e7079.member_19, _e7079.member_20, _e7079.member_21, _e7079.member_22, _e7079.member_23, _e7079.member_24, _e7079.member_25, _e7079.member_26, _e7079.member_27);
let _e7135 = type_27(_e7107.member, _e7107.member_1, _e7107.member_2, _e7107.member_3, _e7107.member_4, _e7107.member_5, _e7107.member_6, _e7107.member_7, _e7107.member_8, _e7107.member_9, _e7107.member_10, _e7107.member_11, 0i, _e7107.member_13, _e7107.member_14, _e7107.member_15, _e7107.member_16, _e7107.member_17, _e7107.member_18, _e7107.member_19, _e7107.member_20, _e7107.member_21, _e7107.member_22, _e7107.member_23, _e7107.member_24, _e7107.member_25, _e7107.member_26, _e7107.member_27);
let _e7142 = global_5.member.member_14.member.member;
let _e7156 = ((((_e7142.member.member * _e3114.member.x) + (_e7142.member.member_1 * _e3114.member.y)) + (_e7142.member.member_2 * _e3114.member.z)) + _e7142.member_1);
let _e7165 = -((((_e7142.member.member * _e3114.member_1.x) + (_e7142.member.member_1 * _e3114.member_1.y)) + (_e7142.member.member_2 * _e3114.member_1.z)));
let _e7167 = (_e7165 > 1e-9f);
let _e7171 = ((_e7156 / select(1e-9f, _e7165, _e7167)) - 0.015625f);
let _e7174 = select(1e30f, select(0f, _e7171, (_e7171 > 0f)), ((_e7156 > 0f) && _e7167));
let _e7179 = global_5.member.member_14.member_1.member;
let _e7190 = ((((_e7179.member.member * _e3114.member.x) + (_e7179.member.member_1 * _e3114.member.y)) + (_e7179.member.member_2 * _e3114.member.z)) + _e7179.member_1);
let _e7196 = -((((_e7179.member.member * _e3114.member_1.x) + (_e7179.member.member_1 * _e3114.member_1.y)) + (_e7179.member.member_2 * _e3114.member_1.z)));
let _e7198 = (_e7196 > 1e-9f);
let _e7202 = ((_e7190 / select(1e-9f, _e7196, _e7198)) - 0.015625f);
let _e7205 = select(1e30f, select(0f, _e7202, (_e7202 > 0f)), ((_e7190 > 0f) && _e7198));
let _e7209 = (_e7205 < _e7174);
let _e7240 = type_27(_e7135.member, _e7135.member_1, _e7135.member_2, _e7135.member_3, _e7135.member_4, _e7135.member_5, _e7135.member_6, _e7135.member_7, 0i, _e7135.member_9, _e7135.member_10, _e7135.member_11, _e7135.member_12, _e7135.member_13, _e7135.member_14, _e7135.member_15, _e7135.member_16, _e7135.member_17, _e7135.member_18, _e7135.member_19, _e7135.member_20, _e7135.member_21, _e7135.member_22, _e7135.member_23, _e7135.member_24, _e7135.member_25, _e7135.member_26, _e7135.member_27);
let _e7268 = type_27(_e7240.member, _e7240.member_1, _e7240.member_2, _e7240.member_3, _e7240.member_4, _e7240.member_5, _e7240.member_6, _e7240.member_7, _e7240.member_8, select(select(-2i, -3i, _e7209), -1i, ((_e7174 >= 1e30f) && (_e7205 >= 1e30f))), _e7240.member_10, _e7240.member_11, _e7240.member_12, _e7240.member_13, _e7240.member_14, _e7240.member_15, _e7240.member_16, _e7240.member_17, _e7240.member_18, _e7240.member_19, _e7240.member_20, _e7240.member_21, _e7240.member_22, _e7240.member_23, _e7240.member_24, _e7240.member_25, _e7240.member_26, _e7240.member_27);
phi_12413_ = type_27(_e7268.member, _e7268.member_1, _e7268.member_2, _e7268.member_3, _e7268.member_4, _e7268.member_5, _e7268.member_6, _e7268.member_7, _e7268.member_8, _e7268.member_9, select(_e7174, _e7205, _e7209), _e7268.member_11, _e7268.member_12, _e7268.member_13, _e7268.member_14, _e7268.member_15, _e7268.member_16, _e7268.member_17, _e7268.member_18, _e7268.member_19, _e7268.member_20, _e7268.member_21, _e7268.member_22, _e7268.member_23, _e7268.member_24, _e7268.member_25, _e7268.member_26, _e7268.member_27);
phi_12414_ = type_27();
} else {
let _e3136 = (_e3114.member.x + (_e3114.member_1.x * _e3114.member_10));
let _e3139 = (_e3114.member.y + (_e3114.member_1.y * _e3114.member_10));
let _e3142 = (_e3114.member.z + (_e3114.member_1.z * _e3114.member_10));
let _e3171 = type_27(vec3<f32>(_e3136, _e3139, _e3142), _e3114.member_1, _e3114.member_2, _e3114.member_3, _e3114.member_4, _e3114.member_5, _e3114.member_6, _e3114.member_7, _e3114.member_8, _e3114.member_9, _e3114.member_10, _e3114.member_11, _e3114.member_12, _e3114.member_13, _e3114.member_14, _e3114.member_15, _e3114.member_16, _e3114.member_17, _e3114.member_18, _e3114.member_19, _e3114.member_20, _e3114.member_21, _e3114.member_22, _e3114.member_23, _e3114.member_24, _e3114.member_25, _e3114.member_26, _e3114.member_27);
let _e3173 = (_e3114.member_9 * 19i);
let _e3175 = select(_e1984, _e3173, (_e3173 < _e1984));
let _e3181 = global_2.member[bitcast<u32>(select(0i, _e3175, (_e3175 > 0i)))];
let _e3182 = (_e3173 + 1i);
let _e3184 = select(_e1984, _e3182, (_e3182 < _e1984));
let _e3190 = global_2.member[bitcast<u32>(select(0i, _e3184, (_e3184 > 0i)))];
let _e3191 = (_e3173 + 2i);
let _e3193 = select(_e1984, _e3191, (_e3191 < _e1984));
let _e3199 = global_2.member[bitcast<u32>(select(0i, _e3193, (_e3193 > 0i)))];
let _e3200 = (_e3173 + 3i);
let _e3202 = select(_e1984, _e3200, (_e3200 < _e1984));
let _e3208 = global_2.member[bitcast<u32>(select(0i, _e3202, (_e3202 > 0i)))];
let _e3209 = (_e3173 + 4i);
let _e3211 = select(_e1984, _e3209, (_e3209 < _e1984));
let _e3217 = global_2.member[bitcast<u32>(select(0i, _e3211, (_e3211 > 0i)))];
let _e3218 = (_e3173 + 5i);
let _e3220 = select(_e1984, _e3218, (_e3218 < _e1984));
let _e3226 = global_2.member[bitcast<u32>(select(0i, _e3220, (_e3220 > 0i)))];
let _e3227 = (_e3208 - _e3181);
let _e3228 = (_e3217 - _e3190);
let _e3229 = (_e3226 - _e3199);
let _e3230 = (_e3173 + 6i);
let _e3232 = select(_e1984, _e3230, (_e3230 < _e1984));
let _e3238 = global_2.member[bitcast<u32>(select(0i, _e3232, (_e3232 > 0i)))];
let _e3239 = (_e3173 + 7i);
let _e3241 = select(_e1984, _e3239, (_e3239 < _e1984));
let _e3247 = global_2.member[bitcast<u32>(select(0i, _e3241, (_e3241 > 0i)))];
let _e3248 = (_e3173 + 8i);
let _e3250 = select(_e1984, _e3248, (_e3248 < _e1984));
let _e3256 = global_2.member[bitcast<u32>(select(0i, _e3250, (_e3250 > 0i)))];
let _e3257 = (_e3238 - _e3181);
let _e3258 = (_e3247 - _e3190);
let _e3259 = (_e3256 - _e3199);
let _e3262 = ((_e3228 * _e3259) - (_e3229 * _e3258));
let _e3265 = ((_e3229 * _e3257) - (_e3227 * _e3259));
let _e3268 = ((_e3227 * _e3258) - (_e3228 * _e3257));
let _e3273 = (((_e3262 * _e3262) + (_e3265 * _e3265)) + (_e3268 * _e3268));
let _e3285 = (1f / select(1e-30f, _e3273, (_e3273 > 1e-30f)));
let _e3286 = (((_e3258 * _e3268) - (_e3259 * _e3265)) * _e3285);
let _e3287 = (((_e3259 * _e3262) - (_e3257 * _e3268)) * _e3285);
let _e3288 = (((_e3257 * _e3265) - (_e3258 * _e3262)) * _e3285);
let _e3298 = (((_e3265 * _e3229) - (_e3268 * _e3228)) * _e3285);
let _e3299 = (((_e3268 * _e3227) - (_e3262 * _e3229)) * _e3285);
let _e3300 = (((_e3262 * _e3228) - (_e3265 * _e3227)) * _e3285);
let _e3301 = (_e3173 + 9i);
let _e3303 = select(_e1984, _e3301, (_e3301 < _e1984));
let _e3309 = global_2.member[bitcast<u32>(select(0i, _e3303, (_e3303 > 0i)))];
let _e3310 = (_e3173 + 10i);
let _e3312 = select(_e1984, _e3310, (_e3310 < _e1984));
let _e3318 = global_2.member[bitcast<u32>(select(0i, _e3312, (_e3312 > 0i)))];
let _e3319 = (_e3173 + 11i);
let _e3321 = select(_e1984, _e3319, (_e3319 < _e1984));
let _e3327 = global_2.member[bitcast<u32>(select(0i, _e3321, (_e3321 > 0i)))];
let _e3328 = (_e3173 + 12i);
let _e3330 = select(_e1984, _e3328, (_e3328 < _e1984));
let _e3336 = global_2.member[bitcast<u32>(select(0i, _e3330, (_e3330 > 0i)))];
let _e3337 = (_e3173 + 13i);
let _e3339 = select(_e1984, _e3337, (_e3337 < _e1984));
let _e3345 = global_2.member[bitcast<u32>(select(0i, _e3339, (_e3339 > 0i)))];
let _e3346 = (_e3173 + 14i);
let _e3348 = select(_e1984, _e3346, (_e3346 < _e1984));
let _e3354 = global_2.member[bitcast<u32>(select(0i, _e3348, (_e3348 > 0i)))];
let _e3355 = (_e3336 - _e3309);
let _e3356 = (_e3345 - _e3318);
let _e3357 = (_e3354 - _e3327);
let _e3358 = (_e3173 + 15i);
let _e3360 = select(_e1984, _e3358, (_e3358 < _e1984));
let _e3366 = global_2.member[bitcast<u32>(select(0i, _e3360, (_e3360 > 0i)))];
let _e3367 = (_e3173 + 16i);
let _e3369 = select(_e1984, _e3367, (_e3367 < _e1984));
let _e3375 = global_2.member[bitcast<u32>(select(0i, _e3369, (_e3369 > 0i)))];
let _e3376 = (_e3173 + 17i);
let _e3378 = select(_e1984, _e3376, (_e3376 < _e1984));
let _e3384 = global_2.member[bitcast<u32>(select(0i, _e3378, (_e3378 > 0i)))];
let _e3385 = (_e3366 - _e3309);
let _e3386 = (_e3375 - _e3318);
let _e3387 = (_e3384 - _e3327);
let _e3388 = (_e3136 - _e3181);
let _e3389 = (_e3139 - _e3190);
let _e3390 = (_e3142 - _e3199);
let _e3395 = (((_e3286 * _e3388) + (_e3287 * _e3389)) + (_e3288 * _e3390));
let _e3406 = (((_e3298 * _e3388) + (_e3299 * _e3389)) + (_e3300 * _e3390));
let _e3410 = ((_e3309 + (_e3355 * _e3395)) + (_e3385 * _e3406));
let _e3411 = ((_e3318 + (_e3356 * _e3395)) + (_e3386 * _e3406));
let _e3412 = ((_e3327 + (_e3357 * _e3395)) + (_e3387 * _e3406));
let _e3417 = (((_e3410 * _e3410) + (_e3411 * _e3411)) + (_e3412 * _e3412));
let _e3420 = sqrt(select(0f, _e3417, (_e3417 > 0f)));
let _e3423 = (1f / select(1e-20f, _e3420, (_e3420 > 1e-20f)));
let _e3426 = sqrt(select(0f, _e3273, (_e3273 > 0f)));
let _e3429 = (1f / select(1e-20f, _e3426, (_e3426 > 1e-20f)));
let _e3430 = (_e3262 * _e3429);
let _e3431 = (_e3265 * _e3429);
let _e3432 = (_e3268 * _e3429);
let _e3433 = (_e3410 * _e3423);
let _e3434 = (_e3411 * _e3423);
let _e3435 = (_e3412 * _e3423);
if _e2014 {
phi_8843_ = 1f;
phi_8844_ = 1f;
} else {
let _e3437 = local_20;
let _e3438 = (_e3437 * 4i);
let _e3440 = select(_e2002, _e3438, (_e3438 < _e2002));
let _e3446 = global_3.member[bitcast<u32>(select(0i, _e3440, (_e3440 > 0i)))];
let _e3449 = local_21;
let _e3450 = (_e3449 * 4i);
let _e3452 = select(_e2002, _e3450, (_e3450 < _e2002));
let _e3458 = global_3.member[bitcast<u32>(select(0i, _e3452, (_e3452 > 0i)))];
let _e3460 = local_22;
phi_8843_ = select(_e3458, 1f, (_e3460 == 16i));
phi_8844_ = select(_e3446, 1f, _e1957);
}
let _e3464 = phi_8843_;
let _e3466 = phi_8844_;
let _e3473 = select(1f, -1f, ((((_e3114.member_1.x * _e3433) + (_e3114.member_1.y * _e3434)) + (_e3114.member_1.z * _e3435)) > 0f));
let _e3474 = (_e3433 * _e3473);
let _e3475 = (_e3434 * _e3473);
let _e3476 = (_e3435 * _e3473);
let _e3482 = -((((_e3114.member_1.x * _e3474) + (_e3114.member_1.y * _e3475)) + (_e3114.member_1.z * _e3476)));
let _e3484 = select(0f, _e3482, (_e3482 > 0f));
let _e3485 = (_e3466 / _e3464);
let _e3490 = (1f - ((_e3485 * _e3485) * (1f - (_e3484 * _e3484))));
let _e3491 = (_e3490 <= 0f);
let _e3499 = ((_e3485 * _e3484) - sqrt(select(0f, _e3490, (_e3490 > 0f))));
let _e3506 = (2f * _e3484);
let _e3510 = (_e3114.member_1.x + (_e3474 * _e3506));
let _e3511 = (_e3114.member_1.y + (_e3475 * _e3506));
let _e3512 = (_e3114.member_1.z + (_e3476 * _e3506));
let _e3513 = select(((_e3114.member_1.x * _e3485) + (_e3474 * _e3499)), _e3510, _e3491);
let _e3514 = select(((_e3114.member_1.y * _e3485) + (_e3475 * _e3499)), _e3511, _e3491);
let _e3515 = select(((_e3114.member_1.z * _e3485) + (_e3476 * _e3499)), _e3512, _e3491);
let _e3520 = (((_e3513 * _e3513) + (_e3514 * _e3514)) + (_e3515 * _e3515));
let _e3523 = sqrt(select(0f, _e3520, (_e3520 > 0f)));
let _e3526 = (1f / select(1e-20f, _e3523, (_e3523 > 1e-20f)));
let _e3534 = (((_e3114.member_1.x * _e3430) + (_e3114.member_1.y * _e3431)) + (_e3114.member_1.z * _e3432));
let _e3561 = !((((((((_e3433 * _e3114.member_1.x) + (_e3434 * _e3114.member_1.y)) + (_e3435 * _e3114.member_1.z)) * _e3534) > 0f) && (((((((_e3513 * _e3526) * _e3430) + ((_e3514 * _e3526) * _e3431)) + ((_e3515 * _e3526) * _e3432)) * select(1f, -1f, _e3491)) * _e3534) > 0f)) && ((-((((_e3510 * _e3430) + (_e3511 * _e3431)) + (_e3512 * _e3432))) * _e3534) > 0f)));
let _e3562 = select(_e3433, _e3430, _e3561);
let _e3563 = select(_e3434, _e3431, _e3561);
let _e3564 = select(_e3435, _e3432, _e3561);
let _e3565 = select(_e3286, 0f, _e3561);
let _e3566 = select(_e3287, 0f, _e3561);
let _e3567 = select(_e3288, 0f, _e3561);
let _e3568 = select(_e3298, 0f, _e3561);
let _e3569 = select(_e3299, 0f, _e3561);
let _e3570 = select(_e3300, 0f, _e3561);
let _e3582 = (_e3114.member_2.x + (_e3114.member_4.x * _e3114.member_10));
let _e3584 = (_e3114.member_2.y + (_e3114.member_4.y * _e3114.member_10));
let _e3586 = (_e3114.member_2.z + (_e3114.member_4.z * _e3114.member_10));
let _e3594 = (_e3114.member_3.x + (_e3114.member_5.x * _e3114.member_10));
let _e3596 = (_e3114.member_3.y + (_e3114.member_5.y * _e3114.member_10));
let _e3598 = (_e3114.member_3.z + (_e3114.member_5.z * _e3114.member_10));
if ((_e3534 * _e3534) > 1e-12f) {
phi_9077_ = (1f / _e3534);
} else {
phi_9077_ = 0f;
}
let _e3603 = phi_9077_;
let _e3609 = ((((_e3582 * _e3430) + (_e3584 * _e3431)) + (_e3586 * _e3432)) * _e3603);
let _e3613 = (_e3582 - (_e3114.member_1.x * _e3609));
let _e3614 = (_e3584 - (_e3114.member_1.y * _e3609));
let _e3615 = (_e3586 - (_e3114.member_1.z * _e3609));
let _e3616 = vec3<f32>(_e3613, _e3614, _e3615);
let _e3622 = ((((_e3594 * _e3430) + (_e3596 * _e3431)) + (_e3598 * _e3432)) * _e3603);
let _e3626 = (_e3594 - (_e3114.member_1.x * _e3622));
let _e3627 = (_e3596 - (_e3114.member_1.y * _e3622));
let _e3628 = (_e3598 - (_e3114.member_1.z * _e3622));
let _e3629 = vec3<f32>(_e3626, _e3627, _e3628);
let _e3657 = type_27(_e3171.member, _e3171.member_1, _e3616, _e3171.member_3, _e3171.member_4, _e3171.member_5, _e3171.member_6, _e3171.member_7, _e3171.member_8, _e3171.member_9, _e3171.member_10, _e3171.member_11, _e3171.member_12, _e3171.member_13, _e3171.member_14, _e3171.member_15, _e3171.member_16, _e3171.member_17, _e3171.member_18, _e3171.member_19, _e3171.member_20, _e3171.member_21, _e3171.member_22, _e3171.member_23, _e3171.member_24, _e3171.member_25, _e3171.member_26, _e3171.member_27);
let _e3685 = type_27(_e3657.member, _e3657.member_1, _e3657.member_2, _e3629, _e3657.member_4, _e3657.member_5, _e3657.member_6, _e3657.member_7, _e3657.member_8, _e3657.member_9, _e3657.member_10, _e3657.member_11, _e3657.member_12, _e3657.member_13, _e3657.member_14, _e3657.member_15, _e3657.member_16, _e3657.member_17, _e3657.member_18, _e3657.member_19, _e3657.member_20, _e3657.member_21, _e3657.member_22, _e3657.member_23, _e3657.member_24, _e3657.member_25, _e3657.member_26, _e3657.member_27);
let _e3713 = type_27(_e3685.member, _e3685.member_1, _e3685.member_2, _e3685.member_3, _e3114.member_4, _e3685.member_5, _e3685.member_6, _e3685.member_7, _e3685.member_8, _e3685.member_9, _e3685.member_10, _e3685.member_11, _e3685.member_12, _e3685.member_13, _e3685.member_14, _e3685.member_15, _e3685.member_16, _e3685.member_17, _e3685.member_18, _e3685.member_19, _e3685.member_20, _e3685.member_21, _e3685.member_22, _e3685.member_23, _e3685.member_24, _e3685.member_25, _e3685.member_26, _e3685.member_27);
let _e3741 = type_27(_e3713.member, _e3713.member_1, _e3713.member_2, _e3713.member_3, _e3713.member_4, _e3114.member_5, _e3713.member_6, _e3713.member_7, _e3713.member_8, _e3713.member_9, _e3713.member_10, _e3713.member_11, _e3713.member_12, _e3713.member_13, _e3713.member_14, _e3713.member_15, _e3713.member_16, _e3713.member_17, _e3713.member_18, _e3713.member_19, _e3713.member_20, _e3713.member_21, _e3713.member_22, _e3713.member_23, _e3713.member_24, _e3713.member_25, _e3713.member_26, _e3713.member_27);
if _e2014 {
let _e4475 = (_e2000 + 1i);
let _e4477 = select(_e2002, _e4475, (_e4475 < _e2002));
let _e4483 = global_3.member[bitcast<u32>(select(0i, _e4477, (_e4477 > 0i)))];
let _e4484 = (_e2000 + 2i);
let _e4486 = select(_e2002, _e4484, (_e4484 < _e2002));
let _e4492 = global_3.member[bitcast<u32>(select(0i, _e4486, (_e4486 > 0i)))];
let _e4493 = (_e2000 + 3i);
let _e4495 = select(_e2002, _e4493, (_e4493 < _e2002));
let _e4501 = global_3.member[bitcast<u32>(select(0i, _e4495, (_e4495 > 0i)))];
let _e4508 = (1f / 3f);
let _e4512 = (_e3114.member_6.x * _e4483);
let _e4515 = (_e3114.member_6.y * _e4492);
let _e4518 = (_e3114.member_6.z * _e4501);
let _e4547 = type_27(_e3741.member, _e3741.member_1, _e3741.member_2, _e3741.member_3, _e3741.member_4, _e3741.member_5, vec3<f32>(_e4512, _e4515, _e4518), _e3741.member_7, _e3741.member_8, _e3741.member_9, _e3741.member_10, _e3741.member_11, _e3741.member_12, _e3741.member_13, _e3741.member_14, _e3741.member_15, _e3741.member_16, _e3741.member_17, _e3741.member_18, _e3741.member_19, _e3741.member_20, _e3741.member_21, _e3741.member_22, _e3741.member_23, _e3741.member_24, _e3741.member_25, _e3741.member_26, _e3741.member_27);
if (bitcast<i32>(countOneBits(bitcast<u32>((_e3114.member_17 & ((1i << bitcast<u32>((_e3114.member_16 & 31i))) - 1i))))) == _e3114.member_20) {
phi_9208_ = ((((_e3114.member_6.x + _e3114.member_6.y) + _e3114.member_6.z) * _e4508) - (((_e4512 + _e4515) + _e4518) * _e4508));
} else {
phi_9208_ = 0f;
}
let _e4565 = phi_9208_;
let _e4595 = type_27(_e4547.member, _e4547.member_1, _e4547.member_2, _e4547.member_3, _e4547.member_4, _e4547.member_5, _e4547.member_6, _e4547.member_7, _e4547.member_8, _e4547.member_9, _e4547.member_10, _e4547.member_11, _e4547.member_12, _e4547.member_13, _e4547.member_14, _e4547.member_15, _e4547.member_16, _e4547.member_17, _e4547.member_18, _e4547.member_19, _e4547.member_20, _e4547.member_21, _e4547.member_22, _e4547.member_23, _e4547.member_24, (_e3114.member_25 + _e4565), _e4547.member_26, _e4547.member_27);
let _e4602 = select(1f, -1f, ((((_e3562 * _e3114.member_1.x) + (_e3563 * _e3114.member_1.y)) + (_e3564 * _e3114.member_1.z)) > 0f));
let _e4603 = (_e3562 * _e4602);
let _e4604 = (_e3563 * _e4602);
let _e4605 = (_e3564 * _e4602);
let _e4606 = (_e3355 * _e4602);
let _e4607 = (_e3356 * _e4602);
let _e4608 = (_e3357 * _e4602);
let _e4609 = (_e3385 * _e4602);
let _e4610 = (_e3386 * _e4602);
let _e4611 = (_e3387 * _e4602);
let _e4616 = (((_e3565 * _e3613) + (_e3566 * _e3614)) + (_e3567 * _e3615));
let _e4624 = (((_e3568 * _e3613) + (_e3569 * _e3614)) + (_e3570 * _e3615));
let _e4631 = (((_e4606 * _e4616) + (_e4609 * _e4624)) * _e3423);
let _e4632 = (((_e4607 * _e4616) + (_e4610 * _e4624)) * _e3423);
let _e4633 = (((_e4608 * _e4616) + (_e4611 * _e4624)) * _e3423);
let _e4638 = (((_e4603 * _e4631) + (_e4604 * _e4632)) + (_e4605 * _e4633));
let _e4642 = (_e4631 - (_e4603 * _e4638));
let _e4643 = (_e4632 - (_e4604 * _e4638));
let _e4644 = (_e4633 - (_e4605 * _e4638));
let _e4649 = (((_e3114.member_1.x * _e4603) + (_e3114.member_1.y * _e4604)) + (_e3114.member_1.z * _e4605));
let _e4650 = -(_e4649);
let _e4662 = -(((((_e3114.member_4.x * _e4603) + (_e3114.member_4.y * _e4604)) + (_e3114.member_4.z * _e4605)) + (((_e3114.member_1.x * _e4642) + (_e3114.member_1.y * _e4643)) + (_e3114.member_1.z * _e4644))));
let _e4681 = (((_e3565 * _e3626) + (_e3566 * _e3627)) + (_e3567 * _e3628));
let _e4689 = (((_e3568 * _e3626) + (_e3569 * _e3627)) + (_e3570 * _e3628));
let _e4696 = (((_e4606 * _e4681) + (_e4609 * _e4689)) * _e3423);
let _e4697 = (((_e4607 * _e4681) + (_e4610 * _e4689)) * _e3423);
let _e4698 = (((_e4608 * _e4681) + (_e4611 * _e4689)) * _e3423);
let _e4703 = (((_e4603 * _e4696) + (_e4604 * _e4697)) + (_e4605 * _e4698));
let _e4707 = (_e4696 - (_e4603 * _e4703));
let _e4708 = (_e4697 - (_e4604 * _e4703));
let _e4709 = (_e4698 - (_e4605 * _e4703));
let _e4721 = -(((((_e3114.member_5.x * _e4603) + (_e3114.member_5.y * _e4604)) + (_e3114.member_5.z * _e4605)) + (((_e3114.member_1.x * _e4707) + (_e3114.member_1.y * _e4708)) + (_e3114.member_1.z * _e4709))));
let _e4763 = type_27(_e4595.member, _e4595.member_1, _e3616, _e4595.member_3, _e4595.member_4, _e4595.member_5, _e4595.member_6, _e4595.member_7, _e4595.member_8, _e4595.member_9, _e4595.member_10, _e4595.member_11, _e4595.member_12, _e4595.member_13, _e4595.member_14, _e4595.member_15, _e4595.member_16, _e4595.member_17, _e4595.member_18, _e4595.member_19, _e4595.member_20, _e4595.member_21, _e4595.member_22, _e4595.member_23, _e4595.member_24, _e4595.member_25, _e4595.member_26, _e4595.member_27);
let _e4791 = type_27(_e4763.member, _e4763.member_1, _e4763.member_2, _e3629, _e4763.member_4, _e4763.member_5, _e4763.member_6, _e4763.member_7, _e4763.member_8, _e4763.member_9, _e4763.member_10, _e4763.member_11, _e4763.member_12, _e4763.member_13, _e4763.member_14, _e4763.member_15, _e4763.member_16, _e4763.member_17, _e4763.member_18, _e4763.member_19, _e4763.member_20, _e4763.member_21, _e4763.member_22, _e4763.member_23, _e4763.member_24, _e4763.member_25, _e4763.member_26, _e4763.member_27);
let _e4819 = type_27(_e4791.member, _e4791.member_1, _e4791.member_2, _e4791.member_3, (_e3114.member_4 + vec3<f32>((((_e4642 * _e4650) + (_e4603 * _e4662)) * 2f), (((_e4643 * _e4650) + (_e4604 * _e4662)) * 2f), (((_e4644 * _e4650) + (_e4605 * _e4662)) * 2f))), _e4791.member_5, _e4791.member_6, _e4791.member_7, _e4791.member_8, _e4791.member_9, _e4791.member_10, _e4791.member_11, _e4791.member_12, _e4791.member_13, _e4791.member_14, _e4791.member_15, _e4791.member_16, _e4791.member_17, _e4791.member_18, _e4791.member_19, _e4791.member_20, _e4791.member_21, _e4791.member_22, _e4791.member_23, _e4791.member_24, _e4791.member_25, _e4791.member_26, _e4791.member_27);
let _e4847 = type_27(_e4819.member, _e4819.member_1, _e4819.member_2, _e4819.member_3, _e4819.member_4, (_e3114.member_5 + vec3<f32>((((_e4707 * _e4650) + (_e4603 * _e4721)) * 2f), (((_e4708 * _e4650) + (_e4604 * _e4721)) * 2f), (((_e4709 * _e4650) + (_e4605 * _e4721)) * 2f))), _e4819.member_6, _e4819.member_7, _e4819.member_8, _e4819.member_9, _e4819.member_10, _e4819.member_11, _e4819.member_12, _e4819.member_13, _e4819.member_14, _e4819.member_15, _e4819.member_16, _e4819.member_17, _e4819.member_18, _e4819.member_19, _e4819.member_20, _e4819.member_21, _e4819.member_22, _e4819.member_23, _e4819.member_24, _e4819.member_25, _e4819.member_26, _e4819.member_27);
let _e4849 = select(1f, -1f, (_e4649 > 0f));
let _e4850 = (_e4603 * _e4849);
let _e4851 = (_e4604 * _e4849);
let _e4852 = (_e4605 * _e4849);
let _e4858 = -((((_e3114.member_1.x * _e4850) + (_e3114.member_1.y * _e4851)) + (_e3114.member_1.z * _e4852)));
let _e4861 = (2f * select(0f, _e4858, (_e4858 > 0f)));
let _e4894 = type_27(_e4847.member, (_e3114.member_1 + vec3<f32>((_e4850 * _e4861), (_e4851 * _e4861), (_e4852 * _e4861))), _e4847.member_2, _e4847.member_3, _e4847.member_4, _e4847.member_5, _e4847.member_6, _e4847.member_7, _e4847.member_8, _e4847.member_9, _e4847.member_10, _e4847.member_11, _e4847.member_12, _e4847.member_13, _e4847.member_14, _e4847.member_15, _e4847.member_16, _e4847.member_17, _e4847.member_18, _e4847.member_19, _e4847.member_20, _e4847.member_21, _e4847.member_22, _e4847.member_23, _e4847.member_24, _e4847.member_25, _e4847.member_26, _e4847.member_27);
phi_10212_ = type_27(_e4894.member, _e4894.member_1, _e4894.member_2, _e4894.member_3, _e4894.member_4, _e4894.member_5, _e4894.member_6, _e4894.member_7, _e4894.member_8, _e4894.member_9, _e4894.member_10, _e4894.member_11, _e4894.member_12, _e4894.member_13, _e4894.member_14, _e4894.member_15, (_e3114.member_16 + 1i), _e4894.member_17, _e4894.member_18, _e4894.member_19, _e4894.member_20, _e4894.member_21, _e4894.member_22, _e4894.member_23, _e4894.member_24, _e4894.member_25, _e4894.member_26, _e4894.member_27);
} else {
let _e3745 = global_5.member.member_12.member_1;
let _e3747 = local_23;
let _e3748 = (_e3747 * 4i);
let _e3750 = select(_e2002, _e3748, (_e3748 < _e2002));
let _e3756 = global_3.member[bitcast<u32>(select(0i, _e3750, (_e3750 > 0i)))];
let _e3757 = select(_e3756, 1f, _e1957);
let _e3759 = local_24;
let _e3760 = (_e3759 * 4i);
let _e3762 = select(_e2002, _e3760, (_e3760 < _e2002));
let _e3768 = global_3.member[bitcast<u32>(select(0i, _e3762, (_e3762 > 0i)))];
let _e3770 = local_25;
let _e3772 = select(_e3768, 1f, (_e3770 == 16i));
let _e3779 = select(1f, -1f, ((((_e3114.member_1.x * _e3562) + (_e3114.member_1.y * _e3563)) + (_e3114.member_1.z * _e3564)) > 0f));
let _e3780 = (_e3562 * _e3779);
let _e3781 = (_e3563 * _e3779);
let _e3782 = (_e3564 * _e3779);
let _e3788 = -((((_e3114.member_1.x * _e3780) + (_e3114.member_1.y * _e3781)) + (_e3114.member_1.z * _e3782)));
let _e3790 = select(0f, _e3788, (_e3788 > 0f));
let _e3791 = (_e3757 / _e3772);
let _e3792 = (_e3791 * _e3791);
let _e3793 = (_e3790 * _e3790);
let _e3796 = (1f - (_e3792 * (1f - _e3793)));
let _e3797 = (_e3796 <= 0f);
let _e3805 = ((_e3791 * _e3790) - sqrt(select(0f, _e3796, (_e3796 > 0f))));
let _e3812 = (2f * _e3790);
let _e3813 = (_e3780 * _e3812);
let _e3814 = (_e3781 * _e3812);
let _e3815 = (_e3782 * _e3812);
let _e3821 = select(((_e3114.member_1.x * _e3791) + (_e3780 * _e3805)), (_e3114.member_1.x + _e3813), _e3797);
let _e3822 = select(((_e3114.member_1.y * _e3791) + (_e3781 * _e3805)), (_e3114.member_1.y + _e3814), _e3797);
let _e3823 = select(((_e3114.member_1.z * _e3791) + (_e3782 * _e3805)), (_e3114.member_1.z + _e3815), _e3797);
let _e3828 = (((_e3821 * _e3821) + (_e3822 * _e3822)) + (_e3823 * _e3823));
let _e3831 = sqrt(select(0f, _e3828, (_e3828 > 0f)));
let _e3834 = (1f / select(1e-20f, _e3831, (_e3831 > 1e-20f)));
let _e3839 = (_e3772 / _e3757);
let _e3842 = (((_e3839 * _e3839) - 1f) + _e3793);
let _e3845 = sqrt(select(0f, _e3842, (_e3842 > 0f)));
let _e3846 = (_e3845 - _e3790);
let _e3847 = (_e3845 + _e3790);
let _e3850 = (_e3846 / select(1e-6f, _e3847, (_e3847 > 1e-6f)));
let _e3854 = ((_e3790 * _e3846) + 1f);
let _e3857 = (((_e3790 * _e3847) - 1f) / select(1e-6f, _e3854, (_e3854 > 1e-6f)));
let _e3866 = select(select((((0.5f * _e3850) * _e3850) * (1f + (_e3857 * _e3857))), 1f, (_e3842 <= 0f)), 0f, (_e3757 == _e3772));
let _e3869 = (1f - _e3866);
let _e3871 = select(_e3869, _e3866, (_e3866 < _e3869));
let _e3875 = (_e3114.member_16 & 31i);
if (!(_e3797) && (_e3114.member_16 >= _e3114.member_19)) {
let _e3888 = select(_e3114.member_6.y, _e3114.member_6.x, (_e3114.member_6.x > _e3114.member_6.y));
let _e3893 = ((select(_e3114.member_6.z, _e3888, (_e3888 > _e3114.member_6.z)) * _e3871) >= _e3745);
let _e3895 = (1i << bitcast<u32>(_e3875));
if (bitcast<i32>(countOneBits(bitcast<u32>((_e3114.member_17 & (_e3895 - 1i))))) == _e3114.member_20) {
if _e3893 {
phi_9881_ = type_27(_e3741.member, _e3741.member_1, _e3741.member_2, _e3741.member_3, _e3741.member_4, _e3741.member_5, _e3741.member_6, _e3741.member_7, _e3741.member_8, _e3741.member_9, _e3741.member_10, _e3741.member_11, _e3741.member_12, _e3741.member_13, _e3741.member_14, _e3741.member_15, _e3741.member_16, _e3741.member_17, _e3741.member_18, _e3741.member_19, _e3741.member_20, 1i, _e3741.member_22, _e3741.member_23, _e3741.member_24, _e3741.member_25, _e3741.member_26, _e3741.member_27);
} else {
phi_9881_ = type_27(_e3741.member, _e3741.member_1, _e3741.member_2, _e3741.member_3, _e3741.member_4, _e3741.member_5, _e3741.member_6, _e3741.member_7, _e3741.member_8, _e3741.member_9, _e3741.member_10, _e3741.member_11, _e3741.member_12, _e3741.member_13, _e3741.member_14, _e3741.member_15, _e3741.member_16, _e3741.member_17, _e3741.member_18, _e3741.member_19, _e3741.member_20, _e3741.member_21, _e3741.member_22, _e3741.member_23, _e3741.member_24, _e3741.member_25, _e3741.member_26, (_e3114.member_27 + ((((_e3114.member_6.x + _e3114.member_6.y) + _e3114.member_6.z) * (1f / 3f)) * _e3871)));
}
let _e3998 = phi_9881_;
phi_9891_ = _e3998;
} else {
phi_9891_ = type_27(_e3741.member, _e3741.member_1, _e3741.member_2, _e3741.member_3, _e3741.member_4, _e3741.member_5, _e3741.member_6, _e3741.member_7, _e3741.member_8, _e3741.member_9, _e3741.member_10, _e3741.member_11, _e3741.member_12, _e3741.member_13, _e3741.member_14, _e3741.member_15, _e3741.member_16, _e3741.member_17, (_e3114.member_18 | select(0i, _e3895, _e3893)), _e3741.member_19, _e3741.member_20, _e3741.member_21, _e3741.member_22, _e3741.member_23, _e3741.member_24, _e3741.member_25, _e3741.member_26, _e3741.member_27);
}
let _e4000 = phi_9891_;
phi_9892_ = _e4000;
} else {
phi_9892_ = _e3741;
}
let _e4002 = phi_9892_;
let _e4003 = (((_e3114.member_16 < _e3114.member_19) && (((_e3114.member_17 >> bitcast<u32>(_e3875)) & 1i) == 1i)) != (_e3866 > 0.5f));
let _e4004 = (_e3797 || _e4003);
if _e3797 {
phi_9912_ = _e4002;
} else {
let _e4005 = select(_e3869, _e3866, _e4003);
phi_9912_ = type_27(_e4002.member, _e4002.member_1, _e4002.member_2, _e4002.member_3, _e4002.member_4, _e4002.member_5, vec3<f32>((_e4002.member_6.x * _e4005), (_e4002.member_6.y * _e4005), (_e4002.member_6.z * _e4005)), _e4002.member_7, _e4002.member_8, _e4002.member_9, _e4002.member_10, _e4002.member_11, _e4002.member_12, _e4002.member_13, _e4002.member_14, _e4002.member_15, _e4002.member_16, _e4002.member_17, _e4002.member_18, _e4002.member_19, _e4002.member_20, _e4002.member_21, _e4002.member_22, _e4002.member_23, _e4002.member_24, _e4002.member_25, _e4002.member_26, _e4002.member_27);
}
let _e4045 = phi_9912_;
let _e4056 = select(1f, -1f, ((((_e3562 * _e4045.member_1.x) + (_e3563 * _e4045.member_1.y)) + (_e3564 * _e4045.member_1.z)) > 0f));
let _e4057 = (_e3562 * _e4056);
let _e4058 = (_e3563 * _e4056);
let _e4059 = (_e3564 * _e4056);
let _e4060 = (_e3355 * _e4056);
let _e4061 = (_e3356 * _e4056);
let _e4062 = (_e3357 * _e4056);
let _e4063 = (_e3385 * _e4056);
let _e4064 = (_e3386 * _e4056);
let _e4065 = (_e3387 * _e4056);
let _e4077 = (((_e3565 * _e4045.member_2.x) + (_e3566 * _e4045.member_2.y)) + (_e3567 * _e4045.member_2.z));
let _e4085 = (((_e3568 * _e4045.member_2.x) + (_e3569 * _e4045.member_2.y)) + (_e3570 * _e4045.member_2.z));
let _e4092 = (((_e4060 * _e4077) + (_e4063 * _e4085)) * _e3423);
let _e4093 = (((_e4061 * _e4077) + (_e4064 * _e4085)) * _e3423);
let _e4094 = (((_e4062 * _e4077) + (_e4065 * _e4085)) * _e3423);
let _e4099 = (((_e4057 * _e4092) + (_e4058 * _e4093)) + (_e4059 * _e4094));
let _e4103 = (_e4092 - (_e4057 * _e4099));
let _e4104 = (_e4093 - (_e4058 * _e4099));
let _e4105 = (_e4094 - (_e4059 * _e4099));
let _e4111 = -((((_e4045.member_1.x * _e4057) + (_e4045.member_1.y * _e4058)) + (_e4045.member_1.z * _e4059)));
let _e4126 = -(((((_e4045.member_4.x * _e4057) + (_e4045.member_4.y * _e4058)) + (_e4045.member_4.z * _e4059)) + (((_e4045.member_1.x * _e4103) + (_e4045.member_1.y * _e4104)) + (_e4045.member_1.z * _e4105))));
if _e4004 {
phi_10067_ = (_e4045.member_4 + vec3<f32>((((_e4103 * _e4111) + (_e4057 * _e4126)) * 2f), (((_e4104 * _e4111) + (_e4058 * _e4126)) * 2f), (((_e4105 * _e4111) + (_e4059 * _e4126)) * 2f)));
} else {
let _e4130 = (1f - (_e3792 * (1f - (_e4111 * _e4111))));
let _e4132 = select(1e-12f, _e4130, (_e4130 > 1e-12f));
let _e4135 = sqrt(select(0f, _e4132, (_e4132 > 0f)));
let _e4137 = ((_e3791 * _e4111) - _e4135);
let _e4141 = ((_e3791 - ((_e3792 * _e4111) / _e4135)) * _e4126);
phi_10067_ = vec3<f32>((((_e4045.member_4.x * _e3791) + (_e4103 * _e4137)) + (_e4057 * _e4141)), (((_e4045.member_4.y * _e3791) + (_e4104 * _e4137)) + (_e4058 * _e4141)), (((_e4045.member_4.z * _e3791) + (_e4105 * _e4137)) + (_e4059 * _e4141)));
}
let _e4173 = phi_10067_;
let _e4181 = (((_e3565 * _e4045.member_3.x) + (_e3566 * _e4045.member_3.y)) + (_e3567 * _e4045.member_3.z));
let _e4189 = (((_e3568 * _e4045.member_3.x) + (_e3569 * _e4045.member_3.y)) + (_e3570 * _e4045.member_3.z));
let _e4196 = (((_e4060 * _e4181) + (_e4063 * _e4189)) * _e3423);
let _e4197 = (((_e4061 * _e4181) + (_e4064 * _e4189)) * _e3423);
let _e4198 = (((_e4062 * _e4181) + (_e4065 * _e4189)) * _e3423);
let _e4203 = (((_e4057 * _e4196) + (_e4058 * _e4197)) + (_e4059 * _e4198));
let _e4207 = (_e4196 - (_e4057 * _e4203));
let _e4208 = (_e4197 - (_e4058 * _e4203));
let _e4209 = (_e4198 - (_e4059 * _e4203));
let _e4224 = -(((((_e4045.member_5.x * _e4057) + (_e4045.member_5.y * _e4058)) + (_e4045.member_5.z * _e4059)) + (((_e4045.member_1.x * _e4207) + (_e4045.member_1.y * _e4208)) + (_e4045.member_1.z * _e4209))));
if _e4004 {
phi_10193_ = (_e4045.member_5 + vec3<f32>((((_e4207 * _e4111) + (_e4057 * _e4224)) * 2f), (((_e4208 * _e4111) + (_e4058 * _e4224)) * 2f), (((_e4209 * _e4111) + (_e4059 * _e4224)) * 2f)));
} else {
let _e4228 = (1f - (_e3792 * (1f - (_e4111 * _e4111))));
let _e4230 = select(1e-12f, _e4228, (_e4228 > 1e-12f));
let _e4233 = sqrt(select(0f, _e4230, (_e4230 > 0f)));
let _e4235 = ((_e3791 * _e4111) - _e4233);
let _e4239 = ((_e3791 - ((_e3792 * _e4111) / _e4233)) * _e4224);
phi_10193_ = vec3<f32>((((_e4045.member_5.x * _e3791) + (_e4207 * _e4235)) + (_e4057 * _e4239)), (((_e4045.member_5.y * _e3791) + (_e4208 * _e4235)) + (_e4058 * _e4239)), (((_e4045.member_5.z * _e3791) + (_e4209 * _e4235)) + (_e4059 * _e4239)));
}
let _e4271 = phi_10193_;
let _e4299 = type_27(_e4045.member, _e4045.member_1, _e4045.member_2, _e4045.member_3, _e4045.member_4, _e4045.member_5, _e4045.member_6, _e4045.member_7, _e4045.member_8, _e4045.member_9, _e4045.member_10, _e4045.member_11, _e4045.member_12, _e4045.member_13, _e4045.member_14, _e4045.member_15, _e4045.member_16, _e4045.member_17, _e4045.member_18, _e4045.member_19, _e4045.member_20, _e4045.member_21, _e4045.member_22, _e4045.member_23, _e4045.member_24, _e4045.member_25, _e4045.member_26, _e4045.member_27);
let _e4327 = type_27(_e4299.member, _e4299.member_1, _e4299.member_2, _e4045.member_3, _e4299.member_4, _e4299.member_5, _e4299.member_6, _e4299.member_7, _e4299.member_8, _e4299.member_9, _e4299.member_10, _e4299.member_11, _e4299.member_12, _e4299.member_13, _e4299.member_14, _e4299.member_15, _e4299.member_16, _e4299.member_17, _e4299.member_18, _e4299.member_19, _e4299.member_20, _e4299.member_21, _e4299.member_22, _e4299.member_23, _e4299.member_24, _e4299.member_25, _e4299.member_26, _e4299.member_27);
let _e4355 = type_27(_e4327.member, _e4327.member_1, _e4327.member_2, _e4327.member_3, _e4173, _e4327.member_5, _e4327.member_6, _e4327.member_7, _e4327.member_8, _e4327.member_9, _e4327.member_10, _e4327.member_11, _e4327.member_12, _e4327.member_13, _e4327.member_14, _e4327.member_15, _e4327.member_16, _e4327.member_17, _e4327.member_18, _e4327.member_19, _e4327.member_20, _e4327.member_21, _e4327.member_22, _e4327.member_23, _e4327.member_24, _e4327.member_25, _e4327.member_26, _e4327.member_27);
let _e4383 = type_27(_e4355.member, _e4355.member_1, _e4355.member_2, _e4355.member_3, _e4355.member_4, _e4271, _e4355.member_6, _e4355.member_7, _e4355.member_8, _e4355.member_9, _e4355.member_10, _e4355.member_11, _e4355.member_12, _e4355.member_13, _e4355.member_14, _e4355.member_15, _e4355.member_16, _e4355.member_17, _e4355.member_18, _e4355.member_19, _e4355.member_20, _e4355.member_21, _e4355.member_22, _e4355.member_23, _e4355.member_24, _e4355.member_25, _e4355.member_26, _e4355.member_27);
let _e4413 = type_27(_e4383.member, select(vec3<f32>((_e3821 * _e3834), (_e3822 * _e3834), (_e3823 * _e3834)), (_e3114.member_1 + vec3<f32>(_e3813, _e3814, _e3815)), vec3(_e4004)), _e4383.member_2, _e4383.member_3, _e4383.member_4, _e4383.member_5, _e4383.member_6, _e4383.member_7, _e4383.member_8, _e4383.member_9, _e4383.member_10, _e4383.member_11, _e4383.member_12, _e4383.member_13, _e4383.member_14, _e4383.member_15, _e4383.member_16, _e4383.member_17, _e4383.member_18, _e4383.member_19, _e4383.member_20, _e4383.member_21, _e4383.member_22, _e4383.member_23, _e4383.member_24, _e4383.member_25, _e4383.member_26, _e4383.member_27);
let _e4443 = type_27(_e4413.member, _e4413.member_1, _e4413.member_2, _e4413.member_3, _e4413.member_4, _e4413.member_5, _e4413.member_6, _e4413.member_7, _e4413.member_8, _e4413.member_9, _e4413.member_10, _e4413.member_11, _e4413.member_12, _e4413.member_13, _e4413.member_14, _e4413.member_15, (_e4045.member_16 + 1i), _e4413.member_17, _e4413.member_18, _e4413.member_19, _e4413.member_20, _e4413.member_21, _e4413.member_22, _e4413.member_23, _e4413.member_24, _e4413.member_25, _e4413.member_26, _e4413.member_27);
if !(_e4004) {
phi_10211_ = type_27(_e4443.member, _e4443.member_1, _e4443.member_2, _e4443.member_3, _e4443.member_4, _e4443.member_5, _e4443.member_6, _e2023, _e4443.member_8, _e4443.member_9, _e4443.member_10, _e4443.member_11, _e4443.member_12, _e4443.member_13, _e4443.member_14, _e4443.member_15, _e4443.member_16, _e4443.member_17, _e4443.member_18, _e4443.member_19, _e4443.member_20, _e4443.member_21, _e4443.member_22, _e4443.member_23, _e4443.member_24, _e4443.member_25, _e4443.member_26, _e4443.member_27);
} else {
phi_10211_ = _e4443;
}
let _e4474 = phi_10211_;
phi_10212_ = _e4474;
}
let _e4925 = phi_10212_;
let _e4953 = type_27(_e4925.member, _e4925.member_1, _e4925.member_2, _e4925.member_3, _e4925.member_4, _e4925.member_5, _e4925.member_6, _e4925.member_7, _e4925.member_8, _e4925.member_9, _e4925.member_10, _e4925.member_11, _e4925.member_12, 0f, _e4925.member_14, _e4925.member_15, _e4925.member_16, _e4925.member_17, _e4925.member_18, _e4925.member_19, _e4925.member_20, _e4925.member_21, _e4925.member_22, _e4925.member_23, _e4925.member_24, _e4925.member_25, _e4925.member_26, _e4925.member_27);
let _e4981 = type_27(_e4953.member, _e4953.member_1, _e4953.member_2, _e4953.member_3, _e4953.member_4, _e4953.member_5, _e4953.member_6, _e4953.member_7, _e4953.member_8, _e4953.member_9, _e4953.member_10, 0i, _e4953.member_12, _e4953.member_13, _e4953.member_14, _e4953.member_15, _e4953.member_16, _e4953.member_17, _e4953.member_18, _e4953.member_19, _e4953.member_20, _e4953.member_21, _e4953.member_22, _e4953.member_23, _e4953.member_24, _e4953.member_25, _e4953.member_26, _e4953.member_27);
let _e5009 = type_27(_e4981.member, _e4981.member_1, _e4981.member_2, _e4981.member_3, _e4981.member_4, _e4981.member_5, _e4981.member_6, _e4981.member_7, _e4981.member_8, _e4981.member_9, _e4981.member_10, _e4981.member_11, 0i, _e4981.member_13, _e4981.member_14, _e4981.member_15, _e4981.member_16, _e4981.member_17, _e4981.member_18, _e4981.member_19, _e4981.member_20, _e4981.member_21, _e4981.member_22, _e4981.member_23, _e4981.member_24, _e4981.member_25, _e4981.member_26, _e4981.member_27);
let _e5016 = global_5.member.member_14.member.member;
let _e5030 = ((((_e5016.member.member * _e4925.member.x) + (_e5016.member.member_1 * _e4925.member.y)) + (_e5016.member.member_2 * _e4925.member.z)) + _e5016.member_1);
let _e5039 = -((((_e5016.member.member * _e4925.member_1.x) + (_e5016.member.member_1 * _e4925.member_1.y)) + (_e5016.member.member_2 * _e4925.member_1.z)));
let _e5041 = (_e5039 > 1e-9f);
let _e5045 = ((_e5030 / select(1e-9f, _e5039, _e5041)) - 0.015625f);
let _e5048 = select(1e30f, select(0f, _e5045, (_e5045 > 0f)), ((_e5030 > 0f) && _e5041));
let _e5053 = global_5.member.member_14.member_1.member;
let _e5064 = ((((_e5053.member.member * _e4925.member.x) + (_e5053.member.member_1 * _e4925.member.y)) + (_e5053.member.member_2 * _e4925.member.z)) + _e5053.member_1);
let _e5070 = -((((_e5053.member.member * _e4925.member_1.x) + (_e5053.member.member_1 * _e4925.member_1.y)) + (_e5053.member.member_2 * _e4925.member_1.z)));
let _e5072 = (_e5070 > 1e-9f);
let _e5076 = ((_e5064 / select(1e-9f, _e5070, _e5072)) - 0.015625f);
let _e5079 = select(1e30f, select(0f, _e5076, (_e5076 > 0f)), ((_e5064 > 0f) && _e5072));
let _e5083 = (_e5079 < _e5048);
let _e5114 = type_27(_e5009.member, _e5009.member_1, _e5009.member_2, _e5009.member_3, _e5009.member_4, _e5009.member_5, _e5009.member_6, _e5009.member_7, 0i, _e5009.member_9, _e5009.member_10, _e5009.member_11, _e5009.member_12, _e5009.member_13, _e5009.member_14, _e5009.member_15, _e5009.member_16, _e5009.member_17, _e5009.member_18, _e5009.member_19, _e5009.member_20, _e5009.member_21, _e5009.member_22, _e5009.member_23, _e5009.member_24, _e5009.member_25, _e5009.member_26, _e5009.member_27);
let _e5142 = type_27(_e5114.member, _e5114.member_1, _e5114.member_2, _e5114.member_3, _e5114.member_4, _e5114.member_5, _e5114.member_6, _e5114.member_7, _e5114.member_8, select(select(-2i, -3i, _e5083), -1i, ((_e5048 >= 1e30f) && (_e5079 >= 1e30f))), _e5114.member_10, _e5114.member_11, _e5114.member_12, _e5114.member_13, _e5114.member_14, _e5114.member_15, _e5114.member_16, _e5114.member_17, _e5114.member_18, _e5114.member_19, _e5114.member_20, _e5114.member_21, _e5114.member_22, _e5114.member_23, _e5114.member_24, _e5114.member_25, _e5114.member_26, _e5114.member_27);
let _e5170 = type_27(_e5142.member, _e5142.member_1, _e5142.member_2, _e5142.member_3, _e5142.member_4, _e5142.member_5, _e5142.member_6, _e5142.member_7, _e5142.member_8, _e5142.member_9, select(_e5048, _e5079, _e5083), _e5142.member_11, _e5142.member_12, _e5142.member_13, _e5142.member_14, _e5142.member_15, _e5142.member_16, _e5142.member_17, _e5142.member_18, _e5142.member_19, _e5142.member_20, _e5142.member_21, _e5142.member_22, _e5142.member_23, _e5142.member_24, _e5142.member_25, _e5142.member_26, _e5142.member_27);
let _e5175 = global_5.member.member_12.member_3;
if (_e4925.member_16 > bitcast<i32>(_e5175)) {
if (bitcast<i32>(countOneBits(bitcast<u32>((_e4925.member_17 & ((1i << bitcast<u32>((_e4925.member_16 & 31i))) - 1i))))) == _e4925.member_20) {
phi_10367_ = (((_e4925.member_6.x + _e4925.member_6.y) + _e4925.member_6.z) * (1f / 3f));
} else {
phi_10367_ = 0f;
}
let _e5198 = phi_10367_;
let _e5228 = type_27(_e5170.member, _e5170.member_1, _e5170.member_2, _e5170.member_3, _e5170.member_4, _e5170.member_5, _e5170.member_6, _e5170.member_7, _e5170.member_8, _e5170.member_9, _e5170.member_10, _e5170.member_11, _e5170.member_12, _e5170.member_13, _e5170.member_14, _e5170.member_15, _e5170.member_16, _e5170.member_17, _e5170.member_18, _e5170.member_19, _e5170.member_20, _e5170.member_21, _e5170.member_22, _e5170.member_23, _e5170.member_24, _e5170.member_25, _e5170.member_26, (_e4925.member_27 + _e5198));
let _e5230 = (_e4925.member_18 == 0i);
if (_e5230 && (_e4925.member_21 == 0i)) {
phi_12411_ = type_27(_e5228.member, _e5228.member_1, _e5228.member_2, _e5228.member_3, _e5228.member_4, _e5228.member_5, _e5228.member_6, _e5228.member_7, _e5228.member_8, _e5228.member_9, _e5228.member_10, _e5228.member_11, _e5228.member_12, _e5228.member_13, _e5228.member_14, 3f, _e5228.member_16, _e5228.member_17, _e5228.member_18, _e5228.member_19, _e5228.member_20, _e5228.member_21, _e5228.member_22, _e5228.member_23, _e5228.member_24, _e5228.member_25, _e5228.member_26, _e5228.member_27);
} else {
if _e5230 {
let _e5360 = type_27(_e5228.member, _e5228.member_1, _e5228.member_2, _e5228.member_3, _e5228.member_4, _e5228.member_5, _e5228.member_6, _e5228.member_7, _e5228.member_8, _e5228.member_9, _e5228.member_10, _e5228.member_11, _e5228.member_12, _e5228.member_13, _e5228.member_14, _e5228.member_15, _e5228.member_16, _e5228.member_17, _e5228.member_18, _e5228.member_19, (_e4925.member_20 + 1i), _e5228.member_21, _e5228.member_22, _e5228.member_23, _e5228.member_24, _e5228.member_25, _e5228.member_26, _e5228.member_27);
let _e5388 = type_27(_e5360.member, _e5360.member_1, _e5360.member_2, _e5360.member_3, _e5360.member_4, _e5360.member_5, _e5360.member_6, _e5360.member_7, _e5360.member_8, _e5360.member_9, _e5360.member_10, _e5360.member_11, _e5360.member_12, _e5360.member_13, _e5360.member_14, _e5360.member_15, _e5360.member_16, _e5360.member_17, _e5360.member_18, _e5360.member_19, _e5360.member_20, 0i, _e5360.member_22, _e5360.member_23, _e5360.member_24, _e5360.member_25, _e5360.member_26, _e5360.member_27);
let _e5416 = type_27(_e5388.member, _e5388.member_1, _e5388.member_2, _e5388.member_3, _e5388.member_4, _e5388.member_5, _e5388.member_6, _e5388.member_7, _e5388.member_8, _e5388.member_9, _e5388.member_10, _e5388.member_11, _e5388.member_12, _e5388.member_13, _e5388.member_14, _e5388.member_15, _e5388.member_16, 0i, _e5388.member_18, _e5388.member_19, _e5388.member_20, _e5388.member_21, _e5388.member_22, _e5388.member_23, _e5388.member_24, _e5388.member_25, _e5388.member_26, _e5388.member_27);
phi_10411_ = type_27(_e5416.member, _e5416.member_1, _e5416.member_2, _e5416.member_3, _e5416.member_4, _e5416.member_5, _e5416.member_6, _e5416.member_7, _e5416.member_8, _e5416.member_9, _e5416.member_10, _e5416.member_11, _e5416.member_12, _e5416.member_13, _e5416.member_14, _e5416.member_15, _e5416.member_16, _e5416.member_17, _e5416.member_18, 0i, _e5416.member_20, _e5416.member_21, _e5416.member_22, _e5416.member_23, _e5416.member_24, _e5416.member_25, _e5416.member_26, _e5416.member_27);
} else {
let _e5238 = bitcast<i32>((bitcast<u32>(f32(_e4925.member_18)) >> bitcast<u32>(23i)));
let _e5242 = (1i << bitcast<u32>(((_e5238 - 127i) & 31i)));
let _e5243 = (_e5242 - 1i);
let _e5273 = type_27(_e5228.member, _e5228.member_1, _e5228.member_2, _e5228.member_3, _e5228.member_4, _e5228.member_5, _e5228.member_6, _e5228.member_7, _e5228.member_8, _e5228.member_9, _e5228.member_10, _e5228.member_11, _e5228.member_12, _e5228.member_13, _e5228.member_14, _e5228.member_15, _e5228.member_16, ((_e4925.member_17 & _e5243) | _e5242), _e5228.member_18, _e5228.member_19, _e5228.member_20, _e5228.member_21, _e5228.member_22, _e5228.member_23, _e5228.member_24, _e5228.member_25, _e5228.member_26, _e5228.member_27);
let _e5302 = type_27(_e5273.member, _e5273.member_1, _e5273.member_2, _e5273.member_3, _e5273.member_4, _e5273.member_5, _e5273.member_6, _e5273.member_7, _e5273.member_8, _e5273.member_9, _e5273.member_10, _e5273.member_11, _e5273.member_12, _e5273.member_13, _e5273.member_14, _e5273.member_15, _e5273.member_16, _e5273.member_17, (_e4925.member_18 & _e5243), _e5273.member_19, _e5273.member_20, _e5273.member_21, _e5273.member_22, _e5273.member_23, _e5273.member_24, _e5273.member_25, _e5273.member_26, _e5273.member_27);
phi_10411_ = type_27(_e5302.member, _e5302.member_1, _e5302.member_2, _e5302.member_3, _e5302.member_4, _e5302.member_5, _e5302.member_6, _e5302.member_7, _e5302.member_8, _e5302.member_9, _e5302.member_10, _e5302.member_11, _e5302.member_12, _e5302.member_13, _e5302.member_14, _e5302.member_15, _e5302.member_16, _e5302.member_17, _e5302.member_18, (_e5238 + -126i), _e5302.member_20, _e5302.member_21, _e5302.member_22, _e5302.member_23, _e5302.member_24, _e5302.member_25, _e5302.member_26, _e5302.member_27);
}
let _e5446 = phi_10411_;
let _e5452 = global_5.member.member_11.member_2;
let _e5459 = global_5.member.member_11.member_3;
let _e5466 = global_5.member.member_11.member_5;
let _e5472 = global_5.member.member_11.member_7;
let _e5474 = (_e5466 + ((f32(bitcast<i32>(_e139.x)) + 0.5f) * _e5472));
let _e5478 = global_5.member.member_11.member_6;
let _e5484 = global_5.member.member_11.member_8;
let _e5486 = (_e5478 + ((f32(bitcast<i32>(_e139.y)) + 0.5f) * _e5484));
let _e5487 = (_e5452.member * _e5472);
let _e5488 = (_e5452.member_1 * _e5472);
let _e5489 = (_e5452.member_2 * _e5472);
let _e5490 = (_e5459.member * _e5484);
let _e5491 = (_e5459.member_1 * _e5484);
let _e5492 = (_e5459.member_2 * _e5484);
let _e5499 = ((_e5452.member * _e5474) + (_e5459.member * _e5486));
let _e5500 = ((_e5452.member_1 * _e5474) + (_e5459.member_1 * _e5486));
let _e5501 = ((_e5452.member_2 * _e5474) + (_e5459.member_2 * _e5486));
let _e5505 = global_5.member.member_11.member_4;
let _e5512 = global_5.member.member_11.member_1;
let _e5519 = global_5.member.member_10.member;
let _e5520 = (_e5519 == 0u);
let _e5521 = (_e5512.member + _e5499);
let _e5522 = (_e5512.member_1 + _e5500);
let _e5523 = (_e5512.member_2 + _e5501);
let _e5528 = (((_e5521 * _e5521) + (_e5522 * _e5522)) + (_e5523 * _e5523));
let _e5532 = (1f / sqrt(select(0f, _e5528, (_e5528 > 0f))));
let _e5536 = select((_e5521 * _e5532), _e5512.member, _e5520);
let _e5537 = select((_e5522 * _e5532), _e5512.member_1, _e5520);
let _e5538 = select((_e5523 * _e5532), _e5512.member_2, _e5520);
let _e5543 = select(_e5505.member, (_e5505.member + _e5499), _e5520);
let _e5544 = select(_e5505.member_1, (_e5505.member_1 + _e5500), _e5520);
let _e5545 = select(_e5505.member_2, (_e5505.member_2 + _e5501), _e5520);
let _e5559 = (((_e5487 * _e5536) + (_e5488 * _e5537)) + (_e5489 * _e5538));
let _e5569 = select(((_e5487 - (_e5536 * _e5559)) * _e5532), 0f, _e5520);
let _e5570 = select(((_e5488 - (_e5537 * _e5559)) * _e5532), 0f, _e5520);
let _e5571 = select(((_e5489 - (_e5538 * _e5559)) * _e5532), 0f, _e5520);
let _e5577 = (((_e5490 * _e5536) + (_e5491 * _e5537)) + (_e5492 * _e5538));
let _e5587 = select(((_e5490 - (_e5536 * _e5577)) * _e5532), 0f, _e5520);
let _e5588 = select(((_e5491 - (_e5537 * _e5577)) * _e5532), 0f, _e5520);
let _e5589 = select(((_e5492 - (_e5538 * _e5577)) * _e5532), 0f, _e5520);
let _e5598 = (1f / select(_e5536, select(1e-12f, -1e-12f, (_e5536 < 0f)), (bitcast<f32>((bitcast<u32>(_e5536) & 2147483647u)) < 1e-12f)));
let _e5606 = (1f / select(_e5537, select(1e-12f, -1e-12f, (_e5537 < 0f)), (bitcast<f32>((bitcast<u32>(_e5537) & 2147483647u)) < 1e-12f)));
let _e5614 = (1f / select(_e5538, select(1e-12f, -1e-12f, (_e5538 < 0f)), (bitcast<f32>((bitcast<u32>(_e5538) & 2147483647u)) < 1e-12f)));
let _e5617 = global_5.member.member_8;
let _e5623 = global_5.member.member_9;
let _e5628 = ((_e5617.member - _e5543) * _e5598);
let _e5630 = ((_e5623.member - _e5543) * _e5598);
let _e5632 = ((_e5617.member_1 - _e5544) * _e5606);
let _e5634 = ((_e5623.member_1 - _e5544) * _e5606);
let _e5636 = ((_e5617.member_2 - _e5545) * _e5614);
let _e5638 = ((_e5623.member_2 - _e5545) * _e5614);
let _e5640 = select(_e5630, _e5628, (_e5628 < _e5630));
let _e5642 = select(_e5634, _e5632, (_e5632 < _e5634));
let _e5644 = select(_e5642, _e5640, (_e5640 > _e5642));
let _e5646 = select(_e5638, _e5636, (_e5636 < _e5638));
let _e5648 = select(_e5646, _e5644, (_e5644 > _e5646));
let _e5650 = select(_e5630, _e5628, (_e5628 > _e5630));
let _e5652 = select(_e5634, _e5632, (_e5632 > _e5634));
let _e5654 = select(_e5652, _e5650, (_e5650 < _e5652));
let _e5656 = select(_e5638, _e5636, (_e5636 > _e5638));
if (true && _e5520) {
phi_10995_ = -(1e30f);
} else {
phi_10995_ = 0f;
}
let _e5662 = phi_10995_;
let _e5664 = select(_e5662, _e5648, (_e5648 > _e5662));
let _e5666 = ((select(_e5656, _e5654, (_e5654 < _e5656)) <= _e5664) || false);
let _e5667 = select(_e5664, 0f, _e5666);
let _e5668 = (_e5536 * _e5667);
let _e5669 = (_e5537 * _e5667);
let _e5670 = (_e5538 * _e5667);
let _e5671 = (_e5543 + _e5668);
let _e5672 = (_e5544 + _e5669);
let _e5673 = (_e5545 + _e5670);
let _e5703 = type_27((vec3<f32>(_e5543, _e5544, _e5545) + vec3<f32>(_e5668, _e5669, _e5670)), _e5446.member_1, _e5446.member_2, _e5446.member_3, _e5446.member_4, _e5446.member_5, _e5446.member_6, _e5446.member_7, _e5446.member_8, _e5446.member_9, _e5446.member_10, _e5446.member_11, _e5446.member_12, _e5446.member_13, _e5446.member_14, _e5446.member_15, _e5446.member_16, _e5446.member_17, _e5446.member_18, _e5446.member_19, _e5446.member_20, _e5446.member_21, _e5446.member_22, _e5446.member_23, _e5446.member_24, _e5446.member_25, _e5446.member_26, _e5446.member_27);
let _e5731 = type_27(_e5703.member, vec3<f32>(_e5536, _e5537, _e5538), _e5703.member_2, _e5703.member_3, _e5703.member_4, _e5703.member_5, _e5703.member_6, _e5703.member_7, _e5703.member_8, _e5703.member_9, _e5703.member_10, _e5703.member_11, _e5703.member_12, _e5703.member_13, _e5703.member_14, _e5703.member_15, _e5703.member_16, _e5703.member_17, _e5703.member_18, _e5703.member_19, _e5703.member_20, _e5703.member_21, _e5703.member_22, _e5703.member_23, _e5703.member_24, _e5703.member_25, _e5703.member_26, _e5703.member_27);
let _e5769 = type_27(_e5731.member, _e5731.member_1, (vec3<f32>(select(0f, _e5487, _e5520), select(0f, _e5488, _e5520), select(0f, _e5489, _e5520)) + vec3<f32>((_e5569 * _e5667), (_e5570 * _e5667), (_e5571 * _e5667))), _e5731.member_3, _e5731.member_4, _e5731.member_5, _e5731.member_6, _e5731.member_7, _e5731.member_8, _e5731.member_9, _e5731.member_10, _e5731.member_11, _e5731.member_12, _e5731.member_13, _e5731.member_14, _e5731.member_15, _e5731.member_16, _e5731.member_17, _e5731.member_18, _e5731.member_19, _e5731.member_20, _e5731.member_21, _e5731.member_22, _e5731.member_23, _e5731.member_24, _e5731.member_25, _e5731.member_26, _e5731.member_27);
let _e5797 = type_27(_e5769.member, _e5769.member_1, _e5769.member_2, (vec3<f32>(select(0f, _e5490, _e5520), select(0f, _e5491, _e5520), select(0f, _e5492, _e5520)) + vec3<f32>((_e5587 * _e5667), (_e5588 * _e5667), (_e5589 * _e5667))), _e5769.member_4, _e5769.member_5, _e5769.member_6, _e5769.member_7, _e5769.member_8, _e5769.member_9, _e5769.member_10, _e5769.member_11, _e5769.member_12, _e5769.member_13, _e5769.member_14, _e5769.member_15, _e5769.member_16, _e5769.member_17, _e5769.member_18, _e5769.member_19, _e5769.member_20, _e5769.member_21, _e5769.member_22, _e5769.member_23, _e5769.member_24, _e5769.member_25, _e5769.member_26, _e5769.member_27);
let _e5825 = type_27(_e5797.member, _e5797.member_1, _e5797.member_2, _e5797.member_3, vec3<f32>(_e5569, _e5570, _e5571), _e5797.member_5, _e5797.member_6, _e5797.member_7, _e5797.member_8, _e5797.member_9, _e5797.member_10, _e5797.member_11, _e5797.member_12, _e5797.member_13, _e5797.member_14, _e5797.member_15, _e5797.member_16, _e5797.member_17, _e5797.member_18, _e5797.member_19, _e5797.member_20, _e5797.member_21, _e5797.member_22, _e5797.member_23, _e5797.member_24, _e5797.member_25, _e5797.member_26, _e5797.member_27);
let _e5853 = type_27(_e5825.member, _e5825.member_1, _e5825.member_2, _e5825.member_3, _e5825.member_4, vec3<f32>(_e5587, _e5588, _e5589), _e5825.member_6, _e5825.member_7, _e5825.member_8, _e5825.member_9, _e5825.member_10, _e5825.member_11, _e5825.member_12, _e5825.member_13, _e5825.member_14, _e5825.member_15, _e5825.member_16, _e5825.member_17, _e5825.member_18, _e5825.member_19, _e5825.member_20, _e5825.member_21, _e5825.member_22, _e5825.member_23, _e5825.member_24, _e5825.member_25, _e5825.member_26, _e5825.member_27);
let _e5881 = type_27(_e5853.member, _e5853.member_1, _e5853.member_2, _e5853.member_3, _e5853.member_4, _e5853.member_5, _e5853.member_6, 0i, _e5853.member_8, _e5853.member_9, _e5853.member_10, _e5853.member_11, _e5853.member_12, _e5853.member_13, _e5853.member_14, _e5853.member_15, _e5853.member_16, _e5853.member_17, _e5853.member_18, _e5853.member_19, _e5853.member_20, _e5853.member_21, _e5853.member_22, _e5853.member_23, _e5853.member_24, _e5853.member_25, _e5853.member_26, _e5853.member_27);
let _e5909 = type_27(_e5881.member, _e5881.member_1, _e5881.member_2, _e5881.member_3, _e5881.member_4, _e5881.member_5, _e5881.member_6, _e5881.member_7, _e5881.member_8, _e5881.member_9, _e5881.member_10, _e5881.member_11, _e5881.member_12, _e5881.member_13, _e5881.member_14, _e5881.member_15, 0i, _e5881.member_17, _e5881.member_18, _e5881.member_19, _e5881.member_20, _e5881.member_21, _e5881.member_22, _e5881.member_23, _e5881.member_24, _e5881.member_25, _e5881.member_26, _e5881.member_27);
let _e5937 = type_27(_e5909.member, _e5909.member_1, _e5909.member_2, _e5909.member_3, _e5909.member_4, _e5909.member_5, _e5909.member_6, _e5909.member_7, _e5909.member_8, _e5909.member_9, _e5909.member_10, _e5909.member_11, _e5909.member_12, _e5909.member_13, _e5909.member_14, 1f, _e5909.member_16, _e5909.member_17, _e5909.member_18, _e5909.member_19, _e5909.member_20, _e5909.member_21, _e5909.member_22, _e5909.member_23, _e5909.member_24, _e5909.member_25, _e5909.member_26, _e5909.member_27);
let _e5965 = type_27(_e5937.member, _e5937.member_1, _e5937.member_2, _e5937.member_3, _e5937.member_4, _e5937.member_5, _e5937.member_6, _e5937.member_7, _e5937.member_8, _e5937.member_9, _e5937.member_10, _e5937.member_11, _e5937.member_12, 0f, _e5937.member_14, _e5937.member_15, _e5937.member_16, _e5937.member_17, _e5937.member_18, _e5937.member_19, _e5937.member_20, _e5937.member_21, _e5937.member_22, _e5937.member_23, _e5937.member_24, _e5937.member_25, _e5937.member_26, _e5937.member_27);
let _e5993 = type_27(_e5965.member, _e5965.member_1, _e5965.member_2, _e5965.member_3, _e5965.member_4, _e5965.member_5, _e5965.member_6, _e5965.member_7, _e5965.member_8, _e5965.member_9, _e5965.member_10, 0i, _e5965.member_12, _e5965.member_13, _e5965.member_14, _e5965.member_15, _e5965.member_16, _e5965.member_17, _e5965.member_18, _e5965.member_19, _e5965.member_20, _e5965.member_21, _e5965.member_22, _e5965.member_23, _e5965.member_24, _e5965.member_25, _e5965.member_26, _e5965.member_27);
let _e6021 = type_27(_e5993.member, _e5993.member_1, _e5993.member_2, _e5993.member_3, _e5993.member_4, _e5993.member_5, _e5993.member_6, _e5993.member_7, _e5993.member_8, _e5993.member_9, _e5993.member_10, _e5993.member_11, 0i, _e5993.member_13, _e5993.member_14, _e5993.member_15, _e5993.member_16, _e5993.member_17, _e5993.member_18, _e5993.member_19, _e5993.member_20, _e5993.member_21, _e5993.member_22, _e5993.member_23, _e5993.member_24, _e5993.member_25, _e5993.member_26, _e5993.member_27);
let _e6027 = ((((_e5016.member.member * _e5671) + (_e5016.member.member_1 * _e5672)) + (_e5016.member.member_2 * _e5673)) + _e5016.member_1);
let _e6033 = -((((_e5016.member.member * _e5536) + (_e5016.member.member_1 * _e5537)) + (_e5016.member.member_2 * _e5538)));
let _e6035 = (_e6033 > 1e-9f);
let _e6039 = ((_e6027 / select(1e-9f, _e6033, _e6035)) - 0.015625f);
let _e6042 = select(1e30f, select(0f, _e6039, (_e6039 > 0f)), ((_e6027 > 0f) && _e6035));
let _e6048 = ((((_e5053.member.member * _e5671) + (_e5053.member.member_1 * _e5672)) + (_e5053.member.member_2 * _e5673)) + _e5053.member_1);
let _e6054 = -((((_e5053.member.member * _e5536) + (_e5053.member.member_1 * _e5537)) + (_e5053.member.member_2 * _e5538)));
let _e6056 = (_e6054 > 1e-9f);
let _e6060 = ((_e6048 / select(1e-9f, _e6054, _e6056)) - 0.015625f);
let _e6063 = select(1e30f, select(0f, _e6060, (_e6060 > 0f)), ((_e6048 > 0f) && _e6056));
let _e6067 = (_e6063 < _e6042);
let _e6098 = type_27(_e6021.member, _e6021.member_1, _e6021.member_2, _e6021.member_3, _e6021.member_4, _e6021.member_5, _e6021.member_6, _e6021.member_7, 0i, _e6021.member_9, _e6021.member_10, _e6021.member_11, _e6021.member_12, _e6021.member_13, _e6021.member_14, _e6021.member_15, _e6021.member_16, _e6021.member_17, _e6021.member_18, _e6021.member_19, _e6021.member_20, _e6021.member_21, _e6021.member_22, _e6021.member_23, _e6021.member_24, _e6021.member_25, _e6021.member_26, _e6021.member_27);
let _e6126 = type_27(_e6098.member, _e6098.member_1, _e6098.member_2, _e6098.member_3, _e6098.member_4, _e6098.member_5, _e6098.member_6, _e6098.member_7, _e6098.member_8, select(select(-2i, -3i, _e6067), -1i, ((_e6042 >= 1e30f) && (_e6063 >= 1e30f))), _e6098.member_10, _e6098.member_11, _e6098.member_12, _e6098.member_13, _e6098.member_14, _e6098.member_15, _e6098.member_16, _e6098.member_17, _e6098.member_18, _e6098.member_19, _e6098.member_20, _e6098.member_21, _e6098.member_22, _e6098.member_23, _e6098.member_24, _e6098.member_25, _e6098.member_26, _e6098.member_27);
let _e6154 = type_27(_e6126.member, _e6126.member_1, _e6126.member_2, _e6126.member_3, _e6126.member_4, _e6126.member_5, _e6126.member_6, _e6126.member_7, _e6126.member_8, _e6126.member_9, select(_e6042, _e6063, _e6067), _e6126.member_11, _e6126.member_12, _e6126.member_13, _e6126.member_14, _e6126.member_15, _e6126.member_16, _e6126.member_17, _e6126.member_18, _e6126.member_19, _e6126.member_20, _e6126.member_21, _e6126.member_22, _e6126.member_23, _e6126.member_24, _e6126.member_25, _e6126.member_26, _e6126.member_27);
let _e6158 = global_5.member.member_13.member_4;
let _e6165 = global_5.member.member_13.member_5;
let _e6170 = ((_e6158.member - _e5543) * _e5598);
let _e6172 = ((_e6165.member - _e5543) * _e5598);
let _e6174 = ((_e6158.member_1 - _e5544) * _e5606);
let _e6176 = ((_e6165.member_1 - _e5544) * _e5606);
let _e6178 = ((_e6158.member_2 - _e5545) * _e5614);
let _e6180 = ((_e6165.member_2 - _e5545) * _e5614);
let _e6182 = select(_e6172, _e6170, (_e6170 < _e6172));
let _e6184 = select(_e6176, _e6174, (_e6174 < _e6176));
let _e6186 = select(_e6184, _e6182, (_e6182 > _e6184));
let _e6188 = select(_e6180, _e6178, (_e6178 < _e6180));
let _e6190 = select(_e6188, _e6186, (_e6186 > _e6188));
let _e6192 = select(_e6172, _e6170, (_e6170 > _e6172));
let _e6194 = select(_e6176, _e6174, (_e6174 > _e6176));
let _e6196 = select(_e6194, _e6192, (_e6192 < _e6194));
let _e6198 = select(_e6180, _e6178, (_e6178 > _e6180));
let _e6200 = select(_e6198, _e6196, (_e6196 < _e6198));
let _e6202 = select(_e5662, _e6190, (_e6190 > _e5662));
let _e6204 = select(_e5667, _e6200, (_e6200 < _e5667));
let _e6205 = (_e6204 > _e6202);
let _e6206 = select(_e5662, _e6202, _e6205);
let _e6208 = (select(_e5662, _e6204, _e6205) - _e6206);
let _e6212 = global_5.member.member_13.member_6;
if (_e6212 == 0u) {
phi_12155_ = _e6208;
} else {
let _e6215 = (_e6208 / f32(_e6212));
phi_11430_ = 0u;
phi_11433_ = 0f;
loop {
let _e6217 = phi_11430_;
let _e6219 = phi_11433_;
local_70 = _e6219;
let _e6222 = ((_e6217 < _e6212) && (_e6208 > 0f));
if _e6222 {
let _e6225 = (_e6206 + (_e6215 * f32(_e6217)));
let _e6226 = (_e6225 + _e6215);
let _e6228 = (0.5f * (_e6225 + _e6226));
let _e6229 = (_e6226 - _e6225);
let _e6230 = (0.28867513f * _e6229);
let _e6231 = (_e6228 - _e6230);
let _e6241 = global_5.member.member_13.member_7;
let _e6242 = bitcast<i32>(_e6241);
let _e6246 = global_5.member.member_13.member_8;
let _e6247 = bitcast<i32>(_e6246);
let _e6251 = global_5.member.member_13.member_9;
let _e6252 = bitcast<i32>(_e6251);
let _e6253 = f32(_e6242);
let _e6255 = (_e6165.member - _e6158.member);
let _e6258 = (((((_e5543 + (_e5536 * _e6231)) - _e6158.member) / _e6255) * _e6253) - 0.5f);
let _e6259 = (_e6253 - 1f);
let _e6261 = select(0f, _e6258, (_e6258 > 0f));
let _e6263 = select(_e6259, _e6261, (_e6261 < _e6259));
let _e6264 = f32(_e6247);
let _e6266 = (_e6165.member_1 - _e6158.member_1);
let _e6269 = (((((_e5544 + (_e5537 * _e6231)) - _e6158.member_1) / _e6266) * _e6264) - 0.5f);
let _e6270 = (_e6264 - 1f);
let _e6272 = select(0f, _e6269, (_e6269 > 0f));
let _e6274 = select(_e6270, _e6272, (_e6272 < _e6270));
let _e6275 = f32(_e6252);
let _e6277 = (_e6165.member_2 - _e6158.member_2);
let _e6280 = (((((_e5545 + (_e5538 * _e6231)) - _e6158.member_2) / _e6277) * _e6275) - 0.5f);
let _e6281 = (_e6275 - 1f);
let _e6283 = select(0f, _e6280, (_e6280 > 0f));
let _e6285 = select(_e6281, _e6283, (_e6283 < _e6281));
let _e6287 = select(0f, _e6263, (_e6263 > 0f));
let _e6289 = select(1e6f, _e6287, (_e6287 < 1e6f));
let _e6296 = select(0i, select(select(i32(_e6289), i32(-2147483648), (_e6289 < -2147483600f)), 2147483647i, (_e6289 > 2147483500f)), (_e6289 == _e6289));
let _e6300 = (_e6296 - select(0i, 1i, (_e6289 < f32(_e6296))));
let _e6302 = select(0f, _e6274, (_e6274 > 0f));
let _e6304 = select(1e6f, _e6302, (_e6302 < 1e6f));
let _e6311 = select(0i, select(select(i32(_e6304), i32(-2147483648), (_e6304 < -2147483600f)), 2147483647i, (_e6304 > 2147483500f)), (_e6304 == _e6304));
let _e6315 = (_e6311 - select(0i, 1i, (_e6304 < f32(_e6311))));
let _e6317 = select(0f, _e6285, (_e6285 > 0f));
let _e6319 = select(1e6f, _e6317, (_e6317 < 1e6f));
let _e6326 = select(0i, select(select(i32(_e6319), i32(-2147483648), (_e6319 < -2147483600f)), 2147483647i, (_e6319 > 2147483500f)), (_e6319 == _e6319));
let _e6330 = (_e6326 - select(0i, 1i, (_e6319 < f32(_e6326))));
let _e6334 = (_e6274 - f32(_e6315));
let _e6336 = (_e6285 - f32(_e6330));
local_2 = (_e6263 - f32(_e6300));
let _e6337 = (_e6300 + 1i);
let _e6339 = select(_e6337, 0i, (_e6337 < 0i));
if (_e6339 >= _e6242) {
phi_11574_ = (_e6242 - 1i);
} else {
phi_11574_ = _e6339;
}
let _e6343 = phi_11574_;
local_3 = (_e6343 - _e6300);
let _e6345 = (_e6315 + 1i);
let _e6347 = select(_e6345, 0i, (_e6345 < 0i));
if (_e6347 >= _e6247) {
phi_11587_ = (_e6247 - 1i);
} else {
phi_11587_ = _e6347;
}
let _e6351 = phi_11587_;
let _e6353 = ((_e6351 - _e6315) * _e6242);
let _e6354 = (_e6330 + 1i);
let _e6356 = select(_e6354, 0i, (_e6354 < 0i));
if (_e6356 >= _e6252) {
phi_11601_ = (_e6252 - 1i);
} else {
phi_11601_ = _e6356;
}
let _e6360 = phi_11601_;
let _e6367 = global_5.member.member_13.member_10;
let _e6368 = bitcast<i32>(_e6367);
let _e6373 = ((_e6368 + (((_e6330 * _e6247) + _e6315) * _e6242)) + _e6300);
let _e6375 = select(_e2002, _e6373, (_e6373 < _e2002));
let _e6380 = global_3.member[bitcast<u32>(select(0i, _e6375, (_e6375 > 0i)))];
let _e6381 = local_2;
let _e6384 = local_3;
let _e6385 = (_e6373 + _e6384);
let _e6387 = select(_e2002, _e6385, (_e6385 < _e2002));
let _e6392 = global_3.member[bitcast<u32>(select(0i, _e6387, (_e6387 > 0i)))];
let _e6393 = local_2;
let _e6396 = (1f - _e6334);
let _e6398 = (_e6373 + _e6353);
let _e6400 = select(_e2002, _e6398, (_e6398 < _e2002));
let _e6405 = global_3.member[bitcast<u32>(select(0i, _e6400, (_e6400 > 0i)))];
let _e6406 = local_2;
let _e6409 = local_3;
let _e6410 = (_e6398 + _e6409);
let _e6412 = select(_e2002, _e6410, (_e6410 < _e2002));
let _e6417 = global_3.member[bitcast<u32>(select(0i, _e6412, (_e6412 > 0i)))];
let _e6418 = local_2;
let _e6423 = (_e6373 + (((_e6360 - _e6330) * _e6242) * _e6247));
let _e6425 = select(_e2002, _e6423, (_e6423 < _e2002));
let _e6430 = global_3.member[bitcast<u32>(select(0i, _e6425, (_e6425 > 0i)))];
let _e6431 = local_2;
let _e6434 = local_3;
let _e6435 = (_e6423 + _e6434);
let _e6437 = select(_e2002, _e6435, (_e6435 < _e2002));
let _e6442 = global_3.member[bitcast<u32>(select(0i, _e6437, (_e6437 > 0i)))];
let _e6443 = local_2;
let _e6447 = (_e6423 + _e6353);
let _e6449 = select(_e2002, _e6447, (_e6447 < _e2002));
let _e6454 = global_3.member[bitcast<u32>(select(0i, _e6449, (_e6449 > 0i)))];
let _e6455 = local_2;
let _e6458 = local_3;
let _e6459 = (_e6447 + _e6458);
let _e6461 = select(_e2002, _e6459, (_e6459 < _e2002));
let _e6466 = global_3.member[bitcast<u32>(select(0i, _e6461, (_e6461 > 0i)))];
let _e6467 = local_2;
let _e6476 = (_e6228 + _e6230);
let _e6486 = (((((_e5543 + (_e5536 * _e6476)) - _e6158.member) / _e6255) * _e6253) - 0.5f);
let _e6488 = select(0f, _e6486, (_e6486 > 0f));
let _e6490 = select(_e6259, _e6488, (_e6488 < _e6259));
let _e6494 = (((((_e5544 + (_e5537 * _e6476)) - _e6158.member_1) / _e6266) * _e6264) - 0.5f);
let _e6496 = select(0f, _e6494, (_e6494 > 0f));
let _e6498 = select(_e6270, _e6496, (_e6496 < _e6270));
let _e6502 = (((((_e5545 + (_e5538 * _e6476)) - _e6158.member_2) / _e6277) * _e6275) - 0.5f);
let _e6504 = select(0f, _e6502, (_e6502 > 0f));
let _e6506 = select(_e6281, _e6504, (_e6504 < _e6281));
let _e6508 = select(0f, _e6490, (_e6490 > 0f));
let _e6510 = select(1e6f, _e6508, (_e6508 < 1e6f));
let _e6517 = select(0i, select(select(i32(_e6510), i32(-2147483648), (_e6510 < -2147483600f)), 2147483647i, (_e6510 > 2147483500f)), (_e6510 == _e6510));
let _e6521 = (_e6517 - select(0i, 1i, (_e6510 < f32(_e6517))));
let _e6523 = select(0f, _e6498, (_e6498 > 0f));
let _e6525 = select(1e6f, _e6523, (_e6523 < 1e6f));
let _e6532 = select(0i, select(select(i32(_e6525), i32(-2147483648), (_e6525 < -2147483600f)), 2147483647i, (_e6525 > 2147483500f)), (_e6525 == _e6525));
let _e6536 = (_e6532 - select(0i, 1i, (_e6525 < f32(_e6532))));
let _e6538 = select(0f, _e6506, (_e6506 > 0f));
let _e6540 = select(1e6f, _e6538, (_e6538 < 1e6f));
let _e6547 = select(0i, select(select(i32(_e6540), i32(-2147483648), (_e6540 < -2147483600f)), 2147483647i, (_e6540 > 2147483500f)), (_e6540 == _e6540));
let _e6551 = (_e6547 - select(0i, 1i, (_e6540 < f32(_e6547))));
let _e6555 = (_e6498 - f32(_e6536));
let _e6557 = (_e6506 - f32(_e6551));
local = (_e6490 - f32(_e6521));
let _e6558 = (_e6521 + 1i);
let _e6560 = select(_e6558, 0i, (_e6558 < 0i));
if (_e6560 >= _e6242) {
phi_11923_ = (_e6242 - 1i);
} else {
phi_11923_ = _e6560;
}
let _e6564 = phi_11923_;
local_1 = (_e6564 - _e6521);
let _e6566 = (_e6536 + 1i);
let _e6568 = select(_e6566, 0i, (_e6566 < 0i));
if (_e6568 >= _e6247) {
phi_11936_ = (_e6247 - 1i);
} else {
phi_11936_ = _e6568;
}
let _e6572 = phi_11936_;
let _e6574 = ((_e6572 - _e6536) * _e6242);
let _e6575 = (_e6551 + 1i);
let _e6577 = select(_e6575, 0i, (_e6575 < 0i));
if (_e6577 >= _e6252) {
phi_11950_ = (_e6252 - 1i);
} else {
phi_11950_ = _e6577;
}
let _e6581 = phi_11950_;
let _e6589 = ((_e6368 + (((_e6551 * _e6247) + _e6536) * _e6242)) + _e6521);
let _e6591 = select(_e2002, _e6589, (_e6589 < _e2002));
let _e6596 = global_3.member[bitcast<u32>(select(0i, _e6591, (_e6591 > 0i)))];
let _e6597 = local;
let _e6600 = local_1;
let _e6601 = (_e6589 + _e6600);
let _e6603 = select(_e2002, _e6601, (_e6601 < _e2002));
let _e6608 = global_3.member[bitcast<u32>(select(0i, _e6603, (_e6603 > 0i)))];
let _e6609 = local;
let _e6612 = (1f - _e6555);
let _e6614 = (_e6589 + _e6574);
let _e6616 = select(_e2002, _e6614, (_e6614 < _e2002));
let _e6621 = global_3.member[bitcast<u32>(select(0i, _e6616, (_e6616 > 0i)))];
let _e6622 = local;
let _e6625 = local_1;
let _e6626 = (_e6614 + _e6625);
let _e6628 = select(_e2002, _e6626, (_e6626 < _e2002));
let _e6633 = global_3.member[bitcast<u32>(select(0i, _e6628, (_e6628 > 0i)))];
let _e6634 = local;
let _e6639 = (_e6589 + (((_e6581 - _e6551) * _e6242) * _e6247));
let _e6641 = select(_e2002, _e6639, (_e6639 < _e2002));
let _e6646 = global_3.member[bitcast<u32>(select(0i, _e6641, (_e6641 > 0i)))];
let _e6647 = local;
let _e6650 = local_1;
let _e6651 = (_e6639 + _e6650);
let _e6653 = select(_e2002, _e6651, (_e6651 < _e2002));
let _e6658 = global_3.member[bitcast<u32>(select(0i, _e6653, (_e6653 > 0i)))];
let _e6659 = local;
let _e6663 = (_e6639 + _e6574);
let _e6665 = select(_e2002, _e6663, (_e6663 < _e2002));
let _e6670 = global_3.member[bitcast<u32>(select(0i, _e6665, (_e6665 > 0i)))];
let _e6671 = local;
let _e6674 = local_1;
let _e6675 = (_e6663 + _e6674);
let _e6677 = select(_e2002, _e6675, (_e6675 < _e2002));
let _e6682 = global_3.member[bitcast<u32>(select(0i, _e6677, (_e6677 > 0i)))];
let _e6683 = local;
phi_11431_ = (_e6217 + 1u);
phi_11434_ = (_e6219 + ((0.5f * (((((((_e6380 * (1f - _e6381)) + (_e6392 * _e6393)) * _e6396) + (((_e6405 * (1f - _e6406)) + (_e6417 * _e6418)) * _e6334)) * (1f - _e6336)) + (((((_e6430 * (1f - _e6431)) + (_e6442 * _e6443)) * _e6396) + (((_e6454 * (1f - _e6455)) + (_e6466 * _e6467)) * _e6334)) * _e6336)) + ((((((_e6596 * (1f - _e6597)) + (_e6608 * _e6609)) * _e6612) + (((_e6621 * (1f - _e6622)) + (_e6633 * _e6634)) * _e6555)) * (1f - _e6557)) + (((((_e6646 * (1f - _e6647)) + (_e6658 * _e6659)) * _e6612) + (((_e6670 * (1f - _e6671)) + (_e6682 * _e6683)) * _e6555)) * _e6557)))) * _e6229));
} else {
phi_11431_ = u32();
phi_11434_ = f32();
}
let _e6698 = phi_11431_;
let _e6700 = phi_11434_;
continue;
continuing {
phi_11430_ = _e6698;
phi_11433_ = _e6700;
break if !(_e6222);
}
}
let _e10456 = local_70;
phi_12155_ = _e10456;
}
let _e6703 = phi_12155_;
let _e6707 = global_5.member.member_13.member;
let _e6712 = -((_e6707.member * _e6703));
let _e6714 = select(-87f, _e6712, (_e6712 > -87f));
let _e6716 = select(88f, _e6714, (_e6714 < 88f));
let _e6718 = ((_e6716 * 1.442695f) + 0.5f);
let _e6720 = select(-127f, _e6718, (_e6718 > -127f));
let _e6722 = select(128f, _e6720, (_e6720 < 128f));
let _e6729 = select(0i, select(select(i32(_e6722), i32(-2147483648), (_e6722 < -2147483600f)), 2147483647i, (_e6722 > 2147483500f)), (_e6722 == _e6722));
let _e6733 = (_e6729 - select(0i, 1i, (_e6722 < f32(_e6729))));
let _e6734 = f32(_e6733);
let _e6738 = ((_e6716 - (_e6734 * 0.6933594f)) - (_e6734 * -2.1219444e-4f));
let _e6760 = -((_e6707.member_1 * _e6703));
let _e6762 = select(-87f, _e6760, (_e6760 > -87f));
let _e6764 = select(88f, _e6762, (_e6762 < 88f));
let _e6766 = ((_e6764 * 1.442695f) + 0.5f);
let _e6768 = select(-127f, _e6766, (_e6766 > -127f));
let _e6770 = select(128f, _e6768, (_e6768 < 128f));
let _e6777 = select(0i, select(select(i32(_e6770), i32(-2147483648), (_e6770 < -2147483600f)), 2147483647i, (_e6770 > 2147483500f)), (_e6770 == _e6770));
let _e6781 = (_e6777 - select(0i, 1i, (_e6770 < f32(_e6777))));
let _e6782 = f32(_e6781);
let _e6786 = ((_e6764 - (_e6782 * 0.6933594f)) - (_e6782 * -2.1219444e-4f));
let _e6808 = -((_e6707.member_2 * _e6703));
let _e6810 = select(-87f, _e6808, (_e6808 > -87f));
let _e6812 = select(88f, _e6810, (_e6810 < 88f));
let _e6814 = ((_e6812 * 1.442695f) + 0.5f);
let _e6816 = select(-127f, _e6814, (_e6814 > -127f));
let _e6818 = select(128f, _e6816, (_e6816 < 128f));
let _e6825 = select(0i, select(select(i32(_e6818), i32(-2147483648), (_e6818 < -2147483600f)), 2147483647i, (_e6818 > 2147483500f)), (_e6818 == _e6818));
let _e6829 = (_e6825 - select(0i, 1i, (_e6818 < f32(_e6825))));
let _e6830 = f32(_e6829);
let _e6834 = ((_e6812 - (_e6830 * 0.6933594f)) - (_e6830 * -2.1219444e-4f));
let _e6857 = (1f / 3f);
let _e6859 = (1f * ((1f + (_e6738 * (1f + (_e6738 * (0.5f + (_e6738 * (0.16666667f + (_e6738 * (0.041666668f + (_e6738 * (0.008333334f + (_e6738 * (0.001388889f + (_e6738 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6733 + 127i)) << bitcast<u32>(23i)))));
let _e6860 = (1f * ((1f + (_e6786 * (1f + (_e6786 * (0.5f + (_e6786 * (0.16666667f + (_e6786 * (0.041666668f + (_e6786 * (0.008333334f + (_e6786 * (0.001388889f + (_e6786 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6781 + 127i)) << bitcast<u32>(23i)))));
let _e6861 = (1f * ((1f + (_e6834 * (1f + (_e6834 * (0.5f + (_e6834 * (0.16666667f + (_e6834 * (0.041666668f + (_e6834 * (0.008333334f + (_e6834 * (0.001388889f + (_e6834 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6829 + 127i)) << bitcast<u32>(23i)))));
let _e6890 = type_27(_e6154.member, _e6154.member_1, _e6154.member_2, _e6154.member_3, _e6154.member_4, _e6154.member_5, vec3<f32>(_e6859, _e6860, _e6861), _e6154.member_7, _e6154.member_8, _e6154.member_9, _e6154.member_10, _e6154.member_11, _e6154.member_12, _e6154.member_13, _e6154.member_14, _e6154.member_15, _e6154.member_16, _e6154.member_17, _e6154.member_18, _e6154.member_19, _e6154.member_20, _e6154.member_21, _e6154.member_22, _e6154.member_23, _e6154.member_24, _e6154.member_25, _e6154.member_26, _e6154.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e5446.member_20) {
phi_12383_ = ((((1f + 1f) + 1f) * _e6857) - (((_e6859 + _e6860) + _e6861) * _e6857));
} else {
phi_12383_ = 0f;
}
let _e6900 = phi_12383_;
let _e6930 = type_27(_e6890.member, _e6890.member_1, _e6890.member_2, _e6890.member_3, _e6890.member_4, _e6890.member_5, _e6890.member_6, _e6890.member_7, _e6890.member_8, _e6890.member_9, _e6890.member_10, _e6890.member_11, _e6890.member_12, _e6890.member_13, _e6890.member_14, _e6890.member_15, _e6890.member_16, _e6890.member_17, _e6890.member_18, _e6890.member_19, _e6890.member_20, _e6890.member_21, _e6890.member_22, _e6890.member_23, _e6890.member_24, _e6890.member_25, (_e5446.member_26 + _e6900), _e6890.member_27);
if _e5666 {
let _e6958 = type_27(_e6930.member, _e6930.member_1, _e6930.member_2, _e6930.member_3, _e6930.member_4, _e6930.member_5, _e6930.member_6, _e6930.member_7, _e1891, _e6930.member_9, _e6930.member_10, _e6930.member_11, _e6930.member_12, _e6930.member_13, _e6930.member_14, _e6930.member_15, _e6930.member_16, _e6930.member_17, _e6930.member_18, _e6930.member_19, _e6930.member_20, _e6930.member_21, _e6930.member_22, _e6930.member_23, _e6930.member_24, _e6930.member_25, _e6930.member_26, _e6930.member_27);
phi_12410_ = type_27(_e6958.member, _e6958.member_1, _e6958.member_2, _e6958.member_3, _e6958.member_4, _e6958.member_5, _e6958.member_6, _e6958.member_7, _e6958.member_8, _e6958.member_9, _e6958.member_10, _e6958.member_11, _e6958.member_12, _e6958.member_13, _e6958.member_14, 3f, _e6958.member_16, _e6958.member_17, _e6958.member_18, _e6958.member_19, _e6958.member_20, _e6958.member_21, _e6958.member_22, _e6958.member_23, _e6958.member_24, _e6958.member_25, _e6958.member_26, _e6958.member_27);
} else {
phi_12410_ = _e6930;
}
let _e6988 = phi_12410_;
phi_12411_ = _e6988;
}
let _e7018 = phi_12411_;
phi_12412_ = _e7018;
} else {
phi_12412_ = _e5170;
}
let _e7020 = phi_12412_;
phi_12413_ = type_27();
phi_12414_ = _e7020;
}
let _e7298 = phi_12413_;
let _e7300 = phi_12414_;
phi_12415_ = _e7298;
phi_12416_ = _e7300;
phi_12417_ = _e3125;
}
let _e9200 = phi_12415_;
let _e9202 = phi_12416_;
let _e9204 = phi_12417_;
if _e9204 {
phi_12421_ = _e9200;
} else {
phi_12421_ = _e9202;
}
let _e9206 = phi_12421_;
phi_12422_ = _e9206;
}
let _e9266 = phi_12422_;
phi_12424_ = _e9266;
phi_12425_ = select(false, _e1929, _e1972);
}
let _e10122 = phi_12424_;
let _e10124 = phi_12425_;
phi_3217_ = _e10122;
phi_3220_ = (_e1927 + 1i);
phi_3222_ = _e10124;
} else {
phi_3217_ = type_27();
phi_3220_ = i32();
phi_3222_ = bool();
}
let _e10126 = phi_3217_;
let _e10128 = phi_3220_;
let _e10130 = phi_3222_;
continue;
continuing {
phi_3216_ = _e10126;
phi_3219_ = _e10128;
phi_3221_ = _e10130;
break if !(_e1933);
}
}
let _e10133 = local_26;
let _e10137 = local_27;
let _e10141 = local_28;
let _e10145 = local_29;
let _e10149 = local_30;
let _e10153 = local_31;
let _e10157 = local_32;
let _e10161 = local_33;
let _e10165 = local_34;
let _e10169 = local_35;
let _e10173 = local_36;
let _e10177 = local_37;
let _e10181 = local_38;
let _e10185 = local_39;
let _e10189 = local_40;
let _e10193 = local_41;
let _e10197 = local_42;
let _e10201 = local_43;
let _e10205 = local_44;
let _e10209 = local_45;
let _e10213 = local_46;
let _e10217 = local_47;
let _e10221 = local_48;
let _e10225 = local_49;
let _e10229 = local_50;
let _e10232 = local_51;
let _e10236 = local_52;
let _e10240 = local_53;
let _e10243 = local_54;
let _e10246 = local_55;
let _e10250 = local_56;
let _e10254 = local_57;
let _e10258 = local_58;
let _e10262 = local_59;
let _e10266 = local_60;
let _e10270 = local_61;
let _e10274 = local_62;
let _e10277 = local_63;
let _e10280 = local_64;
let _e10283 = local_65;
let _e10286 = local_66;
global_4.member[_e162] = _e10133.member.x;
global_4.member[_e174] = _e10137.member.y;
global_4.member[_e185] = _e10141.member.z;
global_4.member[_e196] = _e10145.member_1.x;
global_4.member[_e207] = _e10149.member_1.y;
global_4.member[_e218] = _e10153.member_1.z;
global_4.member[_e229] = _e10157.member_2.x;
global_4.member[_e240] = _e10161.member_2.y;
global_4.member[_e251] = _e10165.member_2.z;
global_4.member[_e262] = _e10169.member_3.x;
global_4.member[_e273] = _e10173.member_3.y;
global_4.member[_e284] = _e10177.member_3.z;
global_4.member[_e295] = _e10181.member_4.x;
global_4.member[_e306] = _e10185.member_4.y;
global_4.member[_e317] = _e10189.member_4.z;
global_4.member[_e328] = _e10193.member_5.x;
global_4.member[_e339] = _e10197.member_5.y;
global_4.member[_e350] = _e10201.member_5.z;
global_4.member[_e361] = _e10205.member_6.x;
global_4.member[_e372] = _e10209.member_6.y;
global_4.member[_e383] = _e10213.member_6.z;
global_4.member[_e394] = f32(_e10217.member_7);
global_4.member[_e405] = f32(_e10221.member_8);
global_4.member[_e416] = f32(_e10225.member_9);
global_4.member[_e427] = _e10229.member_10;
global_4.member[_e438] = f32(_e10232.member_11);
global_4.member[_e449] = f32(_e10236.member_12);
global_4.member[_e460] = _e10240.member_13;
global_4.member[_e471] = _e10243.member_14;
let _e10349 = local_67;
global_4.member[_e482] = _e10349;
global_4.member[_e493] = f32(_e10246.member_16);
global_4.member[_e504] = f32(_e10250.member_17);
global_4.member[_e515] = f32(_e10254.member_18);
global_4.member[_e526] = f32(_e10258.member_19);
global_4.member[_e537] = f32(_e10262.member_20);
global_4.member[_e548] = f32(_e10266.member_21);
global_4.member[_e559] = f32(_e10270.member_22);
global_4.member[_e570] = _e10274.member_23;
global_4.member[_e581] = _e10277.member_24;
global_4.member[_e592] = _e10280.member_25;
global_4.member[_e603] = _e10283.member_26;
global_4.member[_e614] = _e10286.member_27;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
