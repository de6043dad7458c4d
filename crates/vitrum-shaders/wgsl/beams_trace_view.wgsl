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
let _e140 = global;
let _e142 = arrayLength((&global_1.member));
let _e144 = arrayLength((&global_2.member));
let _e147 = arrayLength((&global_3.member));
let _e154 = global_5.member.member;
if (_e140.x < _e154.member) {
if (_e140.y < _e154.member_1) {
let _e161 = (_e154.member * _e154.member_1);
let _e163 = ((_e140.y * _e154.member) + _e140.x);
let _e164 = bitcast<i32>(_e163);
let _e166 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e168 = select(_e166, _e164, (_e164 < _e166));
let _e174 = global_4.member[bitcast<u32>(select(0i, _e168, (_e168 > 0i)))];
let _e175 = (_e161 + _e163);
let _e176 = bitcast<i32>(_e175);
let _e178 = select(_e166, _e176, (_e176 < _e166));
let _e184 = global_4.member[bitcast<u32>(select(0i, _e178, (_e178 > 0i)))];
let _e186 = ((2u * _e161) + _e163);
let _e187 = bitcast<i32>(_e186);
let _e189 = select(_e166, _e187, (_e187 < _e166));
let _e195 = global_4.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e197 = ((3u * _e161) + _e163);
let _e198 = bitcast<i32>(_e197);
let _e200 = select(_e166, _e198, (_e198 < _e166));
let _e206 = global_4.member[bitcast<u32>(select(0i, _e200, (_e200 > 0i)))];
let _e208 = ((4u * _e161) + _e163);
let _e209 = bitcast<i32>(_e208);
let _e211 = select(_e166, _e209, (_e209 < _e166));
let _e217 = global_4.member[bitcast<u32>(select(0i, _e211, (_e211 > 0i)))];
let _e219 = ((5u * _e161) + _e163);
let _e220 = bitcast<i32>(_e219);
let _e222 = select(_e166, _e220, (_e220 < _e166));
let _e228 = global_4.member[bitcast<u32>(select(0i, _e222, (_e222 > 0i)))];
let _e230 = ((6u * _e161) + _e163);
let _e231 = bitcast<i32>(_e230);
let _e233 = select(_e166, _e231, (_e231 < _e166));
let _e239 = global_4.member[bitcast<u32>(select(0i, _e233, (_e233 > 0i)))];
let _e241 = ((7u * _e161) + _e163);
let _e242 = bitcast<i32>(_e241);
let _e244 = select(_e166, _e242, (_e242 < _e166));
let _e250 = global_4.member[bitcast<u32>(select(0i, _e244, (_e244 > 0i)))];
let _e252 = ((8u * _e161) + _e163);
let _e253 = bitcast<i32>(_e252);
let _e255 = select(_e166, _e253, (_e253 < _e166));
let _e261 = global_4.member[bitcast<u32>(select(0i, _e255, (_e255 > 0i)))];
let _e263 = ((9u * _e161) + _e163);
let _e264 = bitcast<i32>(_e263);
let _e266 = select(_e166, _e264, (_e264 < _e166));
let _e272 = global_4.member[bitcast<u32>(select(0i, _e266, (_e266 > 0i)))];
let _e274 = ((10u * _e161) + _e163);
let _e275 = bitcast<i32>(_e274);
let _e277 = select(_e166, _e275, (_e275 < _e166));
let _e283 = global_4.member[bitcast<u32>(select(0i, _e277, (_e277 > 0i)))];
let _e285 = ((11u * _e161) + _e163);
let _e286 = bitcast<i32>(_e285);
let _e288 = select(_e166, _e286, (_e286 < _e166));
let _e294 = global_4.member[bitcast<u32>(select(0i, _e288, (_e288 > 0i)))];
let _e296 = ((12u * _e161) + _e163);
let _e297 = bitcast<i32>(_e296);
let _e299 = select(_e166, _e297, (_e297 < _e166));
let _e305 = global_4.member[bitcast<u32>(select(0i, _e299, (_e299 > 0i)))];
let _e307 = ((13u * _e161) + _e163);
let _e308 = bitcast<i32>(_e307);
let _e310 = select(_e166, _e308, (_e308 < _e166));
let _e316 = global_4.member[bitcast<u32>(select(0i, _e310, (_e310 > 0i)))];
let _e318 = ((14u * _e161) + _e163);
let _e319 = bitcast<i32>(_e318);
let _e321 = select(_e166, _e319, (_e319 < _e166));
let _e327 = global_4.member[bitcast<u32>(select(0i, _e321, (_e321 > 0i)))];
let _e329 = ((15u * _e161) + _e163);
let _e330 = bitcast<i32>(_e329);
let _e332 = select(_e166, _e330, (_e330 < _e166));
let _e338 = global_4.member[bitcast<u32>(select(0i, _e332, (_e332 > 0i)))];
let _e340 = ((16u * _e161) + _e163);
let _e341 = bitcast<i32>(_e340);
let _e343 = select(_e166, _e341, (_e341 < _e166));
let _e349 = global_4.member[bitcast<u32>(select(0i, _e343, (_e343 > 0i)))];
let _e351 = ((17u * _e161) + _e163);
let _e352 = bitcast<i32>(_e351);
let _e354 = select(_e166, _e352, (_e352 < _e166));
let _e360 = global_4.member[bitcast<u32>(select(0i, _e354, (_e354 > 0i)))];
let _e362 = ((18u * _e161) + _e163);
let _e363 = bitcast<i32>(_e362);
let _e365 = select(_e166, _e363, (_e363 < _e166));
let _e371 = global_4.member[bitcast<u32>(select(0i, _e365, (_e365 > 0i)))];
let _e373 = ((19u * _e161) + _e163);
let _e374 = bitcast<i32>(_e373);
let _e376 = select(_e166, _e374, (_e374 < _e166));
let _e382 = global_4.member[bitcast<u32>(select(0i, _e376, (_e376 > 0i)))];
let _e384 = ((20u * _e161) + _e163);
let _e385 = bitcast<i32>(_e384);
let _e387 = select(_e166, _e385, (_e385 < _e166));
let _e393 = global_4.member[bitcast<u32>(select(0i, _e387, (_e387 > 0i)))];
let _e395 = ((21u * _e161) + _e163);
let _e396 = bitcast<i32>(_e395);
let _e398 = select(_e166, _e396, (_e396 < _e166));
let _e404 = global_4.member[bitcast<u32>(select(0i, _e398, (_e398 > 0i)))];
let _e406 = ((22u * _e161) + _e163);
let _e407 = bitcast<i32>(_e406);
let _e409 = select(_e166, _e407, (_e407 < _e166));
let _e415 = global_4.member[bitcast<u32>(select(0i, _e409, (_e409 > 0i)))];
let _e417 = ((23u * _e161) + _e163);
let _e418 = bitcast<i32>(_e417);
let _e420 = select(_e166, _e418, (_e418 < _e166));
let _e426 = global_4.member[bitcast<u32>(select(0i, _e420, (_e420 > 0i)))];
let _e428 = ((24u * _e161) + _e163);
let _e429 = bitcast<i32>(_e428);
let _e431 = select(_e166, _e429, (_e429 < _e166));
let _e437 = global_4.member[bitcast<u32>(select(0i, _e431, (_e431 > 0i)))];
let _e439 = ((25u * _e161) + _e163);
let _e440 = bitcast<i32>(_e439);
let _e442 = select(_e166, _e440, (_e440 < _e166));
let _e448 = global_4.member[bitcast<u32>(select(0i, _e442, (_e442 > 0i)))];
let _e450 = ((26u * _e161) + _e163);
let _e451 = bitcast<i32>(_e450);
let _e453 = select(_e166, _e451, (_e451 < _e166));
let _e459 = global_4.member[bitcast<u32>(select(0i, _e453, (_e453 > 0i)))];
let _e461 = ((27u * _e161) + _e163);
let _e462 = bitcast<i32>(_e461);
let _e464 = select(_e166, _e462, (_e462 < _e166));
let _e470 = global_4.member[bitcast<u32>(select(0i, _e464, (_e464 > 0i)))];
let _e472 = ((28u * _e161) + _e163);
let _e473 = bitcast<i32>(_e472);
let _e475 = select(_e166, _e473, (_e473 < _e166));
let _e481 = global_4.member[bitcast<u32>(select(0i, _e475, (_e475 > 0i)))];
let _e483 = ((29u * _e161) + _e163);
let _e484 = bitcast<i32>(_e483);
let _e486 = select(_e166, _e484, (_e484 < _e166));
let _e492 = global_4.member[bitcast<u32>(select(0i, _e486, (_e486 > 0i)))];
let _e494 = ((30u * _e161) + _e163);
let _e495 = bitcast<i32>(_e494);
let _e497 = select(_e166, _e495, (_e495 < _e166));
let _e503 = global_4.member[bitcast<u32>(select(0i, _e497, (_e497 > 0i)))];
let _e505 = ((31u * _e161) + _e163);
let _e506 = bitcast<i32>(_e505);
let _e508 = select(_e166, _e506, (_e506 < _e166));
let _e514 = global_4.member[bitcast<u32>(select(0i, _e508, (_e508 > 0i)))];
let _e516 = ((32u * _e161) + _e163);
let _e517 = bitcast<i32>(_e516);
let _e519 = select(_e166, _e517, (_e517 < _e166));
let _e525 = global_4.member[bitcast<u32>(select(0i, _e519, (_e519 > 0i)))];
let _e527 = ((33u * _e161) + _e163);
let _e528 = bitcast<i32>(_e527);
let _e530 = select(_e166, _e528, (_e528 < _e166));
let _e536 = global_4.member[bitcast<u32>(select(0i, _e530, (_e530 > 0i)))];
let _e538 = ((34u * _e161) + _e163);
let _e539 = bitcast<i32>(_e538);
let _e541 = select(_e166, _e539, (_e539 < _e166));
let _e547 = global_4.member[bitcast<u32>(select(0i, _e541, (_e541 > 0i)))];
let _e549 = ((35u * _e161) + _e163);
let _e550 = bitcast<i32>(_e549);
let _e552 = select(_e166, _e550, (_e550 < _e166));
let _e558 = global_4.member[bitcast<u32>(select(0i, _e552, (_e552 > 0i)))];
let _e560 = ((36u * _e161) + _e163);
let _e561 = bitcast<i32>(_e560);
let _e563 = select(_e166, _e561, (_e561 < _e166));
let _e569 = global_4.member[bitcast<u32>(select(0i, _e563, (_e563 > 0i)))];
let _e571 = ((37u * _e161) + _e163);
let _e572 = bitcast<i32>(_e571);
let _e574 = select(_e166, _e572, (_e572 < _e166));
let _e580 = global_4.member[bitcast<u32>(select(0i, _e574, (_e574 > 0i)))];
let _e582 = ((38u * _e161) + _e163);
let _e583 = bitcast<i32>(_e582);
let _e585 = select(_e166, _e583, (_e583 < _e166));
let _e591 = global_4.member[bitcast<u32>(select(0i, _e585, (_e585 > 0i)))];
let _e593 = ((39u * _e161) + _e163);
let _e594 = bitcast<i32>(_e593);
let _e596 = select(_e166, _e594, (_e594 < _e166));
let _e602 = global_4.member[bitcast<u32>(select(0i, _e596, (_e596 > 0i)))];
let _e604 = ((40u * _e161) + _e163);
let _e605 = bitcast<i32>(_e604);
let _e607 = select(_e166, _e605, (_e605 < _e166));
let _e613 = global_4.member[bitcast<u32>(select(0i, _e607, (_e607 > 0i)))];
let _e615 = ((41u * _e161) + _e163);
let _e616 = bitcast<i32>(_e615);
let _e618 = select(_e166, _e616, (_e616 < _e166));
let _e624 = global_4.member[bitcast<u32>(select(0i, _e618, (_e618 > 0i)))];
let _e631 = select(0i, select(select(i32(_e569), i32(-2147483648), (_e569 < -2147483600f)), 2147483647i, (_e569 > 2147483500f)), (_e569 == _e569));
let _e636 = global_5.member.member_12.member_4;
let _e642 = select(3u, 0u, ((_e492 == 3f) || ((_e492 == 2f) && (_e631 > bitcast<i32>(_e636)))));
if (_e642 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e651 = atomicLoad((&global_6.member[0u]));
if (_e651 == 0u) {
atomicStore((&global_6.member[0u]), ((_e154.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e154.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e642 > 1u) {
let _e713 = select(0i, select(select(i32(_e514), i32(-2147483648), (_e514 < -2147483600f)), 2147483647i, (_e514 > 2147483500f)), (_e514 == _e514));
let _e720 = select(0i, select(select(i32(_e525), i32(-2147483648), (_e525 < -2147483600f)), 2147483647i, (_e525 > 2147483500f)), (_e525 == _e525));
let _e727 = select(0i, select(select(i32(_e536), i32(-2147483648), (_e536 < -2147483600f)), 2147483647i, (_e536 > 2147483500f)), (_e536 == _e536));
let _e734 = select(0i, select(select(i32(_e547), i32(-2147483648), (_e547 < -2147483600f)), 2147483647i, (_e547 > 2147483500f)), (_e547 == _e547));
let _e741 = select(0i, select(select(i32(_e558), i32(-2147483648), (_e558 < -2147483600f)), 2147483647i, (_e558 > 2147483500f)), (_e558 == _e558));
if (_e492 == 0f) {
let _e749 = global_5.member.member_1.member;
let _e751 = f32(bitcast<i32>(_e749));
let _e755 = global_5.member.member_1.member_1;
let _e757 = f32(bitcast<i32>(_e755));
let _e767 = global_5.member.member_2.member;
let _e768 = (((((f32(bitcast<i32>(_e140.x)) + 0.5f) / _e751) * 2f) - 1f) * _e767);
let _e776 = global_5.member.member_2.member_1;
let _e777 = ((1f - (((f32(bitcast<i32>(_e140.y)) + 0.5f) / _e757) * 2f)) * _e776);
let _e780 = global_5.member.member_3;
let _e789 = global_5.member.member_4;
let _e796 = ((_e780.member * _e768) + (_e789.member * _e777));
let _e797 = ((_e780.member_1 * _e768) + (_e789.member_1 * _e777));
let _e798 = ((_e780.member_2 * _e768) + (_e789.member_2 * _e777));
let _e802 = global_5.member.member_2.member_3;
let _e803 = (_e802 != 0u);
let _e806 = global_5.member.member_5;
let _e813 = select((_e806.member + _e796), _e806.member, _e803);
let _e814 = select((_e806.member_1 + _e797), _e806.member_1, _e803);
let _e815 = select((_e806.member_2 + _e798), _e806.member_2, _e803);
let _e818 = global_5.member.member_6;
let _e825 = select(_e818.member, (_e818.member + _e796), _e803);
let _e826 = select(_e818.member_1, (_e818.member_1 + _e797), _e803);
let _e827 = select(_e818.member_2, (_e818.member_2 + _e798), _e803);
let _e833 = (((_e813 * _e813) + (_e814 * _e814)) + (_e815 * _e815));
let _e837 = (1f / sqrt(select(0f, _e833, (_e833 > 0f))));
let _e838 = (_e813 * _e837);
let _e839 = (_e814 * _e837);
let _e840 = (_e815 * _e837);
let _e843 = ((2f * _e767) / _e751);
let _e844 = (_e780.member * _e843);
let _e845 = (_e780.member_1 * _e843);
let _e846 = (_e780.member_2 * _e843);
let _e848 = ((-2f * _e776) / _e757);
let _e849 = (_e789.member * _e848);
let _e850 = (_e789.member_1 * _e848);
let _e851 = (_e789.member_2 * _e848);
let _e864 = (((_e844 * _e838) + (_e845 * _e839)) + (_e846 * _e840));
let _e874 = select(((_e844 - (_e838 * _e864)) * _e837), 0f, _e803);
let _e875 = select(((_e845 - (_e839 * _e864)) * _e837), 0f, _e803);
let _e876 = select(((_e846 - (_e840 * _e864)) * _e837), 0f, _e803);
let _e882 = (((_e849 * _e838) + (_e850 * _e839)) + (_e851 * _e840));
let _e892 = select(((_e849 - (_e838 * _e882)) * _e837), 0f, _e803);
let _e893 = select(((_e850 - (_e839 * _e882)) * _e837), 0f, _e803);
let _e894 = select(((_e851 - (_e840 * _e882)) * _e837), 0f, _e803);
let _e903 = (1f / select(_e838, select(1e-12f, -1e-12f, (_e838 < 0f)), (bitcast<f32>((bitcast<u32>(_e838) & 2147483647u)) < 1e-12f)));
let _e911 = (1f / select(_e839, select(1e-12f, -1e-12f, (_e839 < 0f)), (bitcast<f32>((bitcast<u32>(_e839) & 2147483647u)) < 1e-12f)));
let _e919 = (1f / select(_e840, select(1e-12f, -1e-12f, (_e840 < 0f)), (bitcast<f32>((bitcast<u32>(_e840) & 2147483647u)) < 1e-12f)));
let _e922 = global_5.member.member_8;
let _e928 = global_5.member.member_9;
let _e933 = ((_e922.member - _e825) * _e903);
let _e935 = ((_e928.member - _e825) * _e903);
let _e937 = ((_e922.member_1 - _e826) * _e911);
let _e939 = ((_e928.member_1 - _e826) * _e911);
let _e941 = ((_e922.member_2 - _e827) * _e919);
let _e943 = ((_e928.member_2 - _e827) * _e919);
let _e945 = select(_e935, _e933, (_e933 < _e935));
let _e947 = select(_e939, _e937, (_e937 < _e939));
let _e949 = select(_e947, _e945, (_e945 > _e947));
let _e951 = select(_e943, _e941, (_e941 < _e943));
let _e953 = select(_e951, _e949, (_e949 > _e951));
let _e955 = select(_e935, _e933, (_e933 > _e935));
let _e957 = select(_e939, _e937, (_e937 > _e939));
let _e959 = select(_e957, _e955, (_e955 < _e957));
let _e961 = select(_e943, _e941, (_e941 > _e943));
let _e965 = select(0f, _e953, (_e953 > 0f));
let _e970 = global_5.member.member_14.member.member;
let _e981 = ((((_e970.member.member * _e825) + (_e970.member.member_1 * _e826)) + (_e970.member.member_2 * _e827)) + _e970.member_1);
let _e987 = -((((_e970.member.member * _e838) + (_e970.member.member_1 * _e839)) + (_e970.member.member_2 * _e840)));
let _e989 = (_e987 > 1e-9f);
let _e991 = select(1e-9f, _e987, _e989);
let _e993 = ((_e981 / _e991) - 0.015625f);
let _e996 = select(1e30f, select(0f, _e993, (_e993 > 0f)), ((_e981 > 0f) && _e989));
let _e1001 = global_5.member.member_14.member_1.member;
let _e1012 = ((((_e1001.member.member * _e825) + (_e1001.member.member_1 * _e826)) + (_e1001.member.member_2 * _e827)) + _e1001.member_1);
let _e1018 = -((((_e1001.member.member * _e838) + (_e1001.member.member_1 * _e839)) + (_e1001.member.member_2 * _e840)));
let _e1020 = (_e1018 > 1e-9f);
let _e1022 = select(1e-9f, _e1018, _e1020);
let _e1024 = ((_e1012 / _e1022) - 0.015625f);
let _e1027 = select(1e30f, select(0f, _e1024, (_e1024 > 0f)), ((_e1012 > 0f) && _e1020));
let _e1033 = ((select(_e961, _e959, (_e959 < _e961)) <= _e965) || (true && (select(_e996, _e1027, (_e1027 < _e996)) <= _e965)));
let _e1034 = select(_e965, 0f, _e1033);
let _e1035 = (_e838 * _e1034);
let _e1036 = (_e839 * _e1034);
let _e1037 = (_e840 * _e1034);
let _e1038 = (_e825 + _e1035);
let _e1039 = (_e826 + _e1036);
let _e1040 = (_e827 + _e1037);
let _e1058 = ((((_e970.member.member * _e1038) + (_e970.member.member_1 * _e1039)) + (_e970.member.member_2 * _e1040)) + _e970.member_1);
let _e1062 = ((_e1058 / _e991) - 0.015625f);
let _e1065 = select(1e30f, select(0f, _e1062, (_e1062 > 0f)), ((_e1058 > 0f) && _e989));
let _e1071 = ((((_e1001.member.member * _e1038) + (_e1001.member.member_1 * _e1039)) + (_e1001.member.member_2 * _e1040)) + _e1001.member_1);
let _e1075 = ((_e1071 / _e1022) - 0.015625f);
let _e1078 = select(1e30f, select(0f, _e1075, (_e1075 > 0f)), ((_e1071 > 0f) && _e1020));
let _e1082 = (_e1078 < _e1065);
let _e1086 = type_27((vec3<f32>(_e825, _e826, _e827) + vec3<f32>(_e1035, _e1036, _e1037)), vec3<f32>(_e838, _e839, _e840), (vec3<f32>(select(0f, _e844, _e803), select(0f, _e845, _e803), select(0f, _e846, _e803)) + vec3<f32>((_e874 * _e1034), (_e875 * _e1034), (_e876 * _e1034))), (vec3<f32>(select(0f, _e849, _e803), select(0f, _e850, _e803), select(0f, _e851, _e803)) + vec3<f32>((_e892 * _e1034), (_e893 * _e1034), (_e894 * _e1034))), vec3<f32>(_e874, _e875, _e876), vec3<f32>(_e892, _e893, _e894), vec3<f32>(1f, 1f, 1f), 0i, 0i, select(select(-2i, -3i, _e1082), -1i, ((_e1065 >= 1e30f) && (_e1078 >= 1e30f))), select(_e1065, _e1078, _e1082), 0i, 0i, 0f, _e481, 1f, 0i, _e713, _e720, _e727, _e734, _e741, _e631, _e580, _e591, _e602, _e613, _e624);
let _e1090 = global_5.member.member_13.member_4;
let _e1097 = global_5.member.member_13.member_5;
let _e1102 = ((_e1090.member - _e825) * _e903);
let _e1104 = ((_e1097.member - _e825) * _e903);
let _e1106 = ((_e1090.member_1 - _e826) * _e911);
let _e1108 = ((_e1097.member_1 - _e826) * _e911);
let _e1110 = ((_e1090.member_2 - _e827) * _e919);
let _e1112 = ((_e1097.member_2 - _e827) * _e919);
let _e1114 = select(_e1104, _e1102, (_e1102 < _e1104));
let _e1116 = select(_e1108, _e1106, (_e1106 < _e1108));
let _e1118 = select(_e1116, _e1114, (_e1114 > _e1116));
let _e1120 = select(_e1112, _e1110, (_e1110 < _e1112));
let _e1122 = select(_e1120, _e1118, (_e1118 > _e1120));
let _e1124 = select(_e1104, _e1102, (_e1102 > _e1104));
let _e1126 = select(_e1108, _e1106, (_e1106 > _e1108));
let _e1128 = select(_e1126, _e1124, (_e1124 < _e1126));
let _e1130 = select(_e1112, _e1110, (_e1110 > _e1112));
let _e1132 = select(_e1130, _e1128, (_e1128 < _e1130));
let _e1134 = select(0f, _e1122, (_e1122 > 0f));
let _e1136 = select(_e1034, _e1132, (_e1132 < _e1034));
let _e1137 = (_e1136 > _e1134);
let _e1138 = select(0f, _e1134, _e1137);
let _e1140 = (select(0f, _e1136, _e1137) - _e1138);
let _e1144 = global_5.member.member_13.member_6;
if (_e1144 == 0u) {
phi_2938_ = _e1140;
} else {
let _e1147 = (_e1140 / f32(_e1144));
phi_2213_ = 0u;
phi_2216_ = 0f;
loop {
let _e1149 = phi_2213_;
let _e1151 = phi_2216_;
local_68 = _e1151;
let _e1154 = ((_e1149 < _e1144) && (_e1140 > 0f));
if _e1154 {
let _e1157 = (_e1138 + (_e1147 * f32(_e1149)));
let _e1158 = (_e1157 + _e1147);
let _e1160 = (0.5f * (_e1157 + _e1158));
let _e1161 = (_e1158 - _e1157);
let _e1162 = (0.28867513f * _e1161);
let _e1163 = (_e1160 - _e1162);
let _e1173 = global_5.member.member_13.member_7;
let _e1174 = bitcast<i32>(_e1173);
let _e1178 = global_5.member.member_13.member_8;
let _e1179 = bitcast<i32>(_e1178);
let _e1183 = global_5.member.member_13.member_9;
let _e1184 = bitcast<i32>(_e1183);
let _e1185 = f32(_e1174);
let _e1187 = (_e1097.member - _e1090.member);
let _e1190 = (((((_e825 + (_e838 * _e1163)) - _e1090.member) / _e1187) * _e1185) - 0.5f);
let _e1191 = (_e1185 - 1f);
let _e1193 = select(0f, _e1190, (_e1190 > 0f));
let _e1195 = select(_e1191, _e1193, (_e1193 < _e1191));
let _e1196 = f32(_e1179);
let _e1198 = (_e1097.member_1 - _e1090.member_1);
let _e1201 = (((((_e826 + (_e839 * _e1163)) - _e1090.member_1) / _e1198) * _e1196) - 0.5f);
let _e1202 = (_e1196 - 1f);
let _e1204 = select(0f, _e1201, (_e1201 > 0f));
let _e1206 = select(_e1202, _e1204, (_e1204 < _e1202));
let _e1207 = f32(_e1184);
let _e1209 = (_e1097.member_2 - _e1090.member_2);
let _e1212 = (((((_e827 + (_e840 * _e1163)) - _e1090.member_2) / _e1209) * _e1207) - 0.5f);
let _e1213 = (_e1207 - 1f);
let _e1215 = select(0f, _e1212, (_e1212 > 0f));
let _e1217 = select(_e1213, _e1215, (_e1215 < _e1213));
let _e1219 = select(0f, _e1195, (_e1195 > 0f));
let _e1221 = select(1e6f, _e1219, (_e1219 < 1e6f));
let _e1228 = select(0i, select(select(i32(_e1221), i32(-2147483648), (_e1221 < -2147483600f)), 2147483647i, (_e1221 > 2147483500f)), (_e1221 == _e1221));
let _e1232 = (_e1228 - select(0i, 1i, (_e1221 < f32(_e1228))));
let _e1234 = select(0f, _e1206, (_e1206 > 0f));
let _e1236 = select(1e6f, _e1234, (_e1234 < 1e6f));
let _e1243 = select(0i, select(select(i32(_e1236), i32(-2147483648), (_e1236 < -2147483600f)), 2147483647i, (_e1236 > 2147483500f)), (_e1236 == _e1236));
let _e1247 = (_e1243 - select(0i, 1i, (_e1236 < f32(_e1243))));
let _e1249 = select(0f, _e1217, (_e1217 > 0f));
let _e1251 = select(1e6f, _e1249, (_e1249 < 1e6f));
let _e1258 = select(0i, select(select(i32(_e1251), i32(-2147483648), (_e1251 < -2147483600f)), 2147483647i, (_e1251 > 2147483500f)), (_e1251 == _e1251));
let _e1262 = (_e1258 - select(0i, 1i, (_e1251 < f32(_e1258))));
let _e1266 = (_e1206 - f32(_e1247));
let _e1268 = (_e1217 - f32(_e1262));
local_14 = (_e1195 - f32(_e1232));
let _e1269 = (_e1232 + 1i);
let _e1271 = select(_e1269, 0i, (_e1269 < 0i));
if (_e1271 >= _e1174) {
phi_2357_ = (_e1174 - 1i);
} else {
phi_2357_ = _e1271;
}
let _e1275 = phi_2357_;
local_15 = (_e1275 - _e1232);
let _e1277 = (_e1247 + 1i);
let _e1279 = select(_e1277, 0i, (_e1277 < 0i));
if (_e1279 >= _e1179) {
phi_2370_ = (_e1179 - 1i);
} else {
phi_2370_ = _e1279;
}
let _e1283 = phi_2370_;
let _e1285 = ((_e1283 - _e1247) * _e1174);
let _e1286 = (_e1262 + 1i);
let _e1288 = select(_e1286, 0i, (_e1286 < 0i));
if (_e1288 >= _e1184) {
phi_2384_ = (_e1184 - 1i);
} else {
phi_2384_ = _e1288;
}
let _e1292 = phi_2384_;
let _e1299 = global_5.member.member_13.member_10;
let _e1300 = bitcast<i32>(_e1299);
let _e1305 = ((_e1300 + (((_e1262 * _e1179) + _e1247) * _e1174)) + _e1232);
let _e1307 = (bitcast<i32>(_e147) - 1i);
let _e1309 = select(_e1307, _e1305, (_e1305 < _e1307));
let _e1314 = global_3.member[bitcast<u32>(select(0i, _e1309, (_e1309 > 0i)))];
let _e1315 = local_14;
let _e1318 = local_15;
let _e1319 = (_e1305 + _e1318);
let _e1321 = select(_e1307, _e1319, (_e1319 < _e1307));
let _e1326 = global_3.member[bitcast<u32>(select(0i, _e1321, (_e1321 > 0i)))];
let _e1327 = local_14;
let _e1330 = (1f - _e1266);
let _e1332 = (_e1305 + _e1285);
let _e1334 = select(_e1307, _e1332, (_e1332 < _e1307));
let _e1339 = global_3.member[bitcast<u32>(select(0i, _e1334, (_e1334 > 0i)))];
let _e1340 = local_14;
let _e1343 = local_15;
let _e1344 = (_e1332 + _e1343);
let _e1346 = select(_e1307, _e1344, (_e1344 < _e1307));
let _e1351 = global_3.member[bitcast<u32>(select(0i, _e1346, (_e1346 > 0i)))];
let _e1352 = local_14;
let _e1357 = (_e1305 + (((_e1292 - _e1262) * _e1174) * _e1179));
let _e1359 = select(_e1307, _e1357, (_e1357 < _e1307));
let _e1364 = global_3.member[bitcast<u32>(select(0i, _e1359, (_e1359 > 0i)))];
let _e1365 = local_14;
let _e1368 = local_15;
let _e1369 = (_e1357 + _e1368);
let _e1371 = select(_e1307, _e1369, (_e1369 < _e1307));
let _e1376 = global_3.member[bitcast<u32>(select(0i, _e1371, (_e1371 > 0i)))];
let _e1377 = local_14;
let _e1381 = (_e1357 + _e1285);
let _e1383 = select(_e1307, _e1381, (_e1381 < _e1307));
let _e1388 = global_3.member[bitcast<u32>(select(0i, _e1383, (_e1383 > 0i)))];
let _e1389 = local_14;
let _e1392 = local_15;
let _e1393 = (_e1381 + _e1392);
let _e1395 = select(_e1307, _e1393, (_e1393 < _e1307));
let _e1400 = global_3.member[bitcast<u32>(select(0i, _e1395, (_e1395 > 0i)))];
let _e1401 = local_14;
let _e1410 = (_e1160 + _e1162);
let _e1420 = (((((_e825 + (_e838 * _e1410)) - _e1090.member) / _e1187) * _e1185) - 0.5f);
let _e1422 = select(0f, _e1420, (_e1420 > 0f));
let _e1424 = select(_e1191, _e1422, (_e1422 < _e1191));
let _e1428 = (((((_e826 + (_e839 * _e1410)) - _e1090.member_1) / _e1198) * _e1196) - 0.5f);
let _e1430 = select(0f, _e1428, (_e1428 > 0f));
let _e1432 = select(_e1202, _e1430, (_e1430 < _e1202));
let _e1436 = (((((_e827 + (_e840 * _e1410)) - _e1090.member_2) / _e1209) * _e1207) - 0.5f);
let _e1438 = select(0f, _e1436, (_e1436 > 0f));
let _e1440 = select(_e1213, _e1438, (_e1438 < _e1213));
let _e1442 = select(0f, _e1424, (_e1424 > 0f));
let _e1444 = select(1e6f, _e1442, (_e1442 < 1e6f));
let _e1451 = select(0i, select(select(i32(_e1444), i32(-2147483648), (_e1444 < -2147483600f)), 2147483647i, (_e1444 > 2147483500f)), (_e1444 == _e1444));
let _e1455 = (_e1451 - select(0i, 1i, (_e1444 < f32(_e1451))));
let _e1457 = select(0f, _e1432, (_e1432 > 0f));
let _e1459 = select(1e6f, _e1457, (_e1457 < 1e6f));
let _e1466 = select(0i, select(select(i32(_e1459), i32(-2147483648), (_e1459 < -2147483600f)), 2147483647i, (_e1459 > 2147483500f)), (_e1459 == _e1459));
let _e1470 = (_e1466 - select(0i, 1i, (_e1459 < f32(_e1466))));
let _e1472 = select(0f, _e1440, (_e1440 > 0f));
let _e1474 = select(1e6f, _e1472, (_e1472 < 1e6f));
let _e1481 = select(0i, select(select(i32(_e1474), i32(-2147483648), (_e1474 < -2147483600f)), 2147483647i, (_e1474 > 2147483500f)), (_e1474 == _e1474));
let _e1485 = (_e1481 - select(0i, 1i, (_e1474 < f32(_e1481))));
let _e1489 = (_e1432 - f32(_e1470));
let _e1491 = (_e1440 - f32(_e1485));
local_12 = (_e1424 - f32(_e1455));
let _e1492 = (_e1455 + 1i);
let _e1494 = select(_e1492, 0i, (_e1492 < 0i));
if (_e1494 >= _e1174) {
phi_2706_ = (_e1174 - 1i);
} else {
phi_2706_ = _e1494;
}
let _e1498 = phi_2706_;
local_13 = (_e1498 - _e1455);
let _e1500 = (_e1470 + 1i);
let _e1502 = select(_e1500, 0i, (_e1500 < 0i));
if (_e1502 >= _e1179) {
phi_2719_ = (_e1179 - 1i);
} else {
phi_2719_ = _e1502;
}
let _e1506 = phi_2719_;
let _e1508 = ((_e1506 - _e1470) * _e1174);
let _e1509 = (_e1485 + 1i);
let _e1511 = select(_e1509, 0i, (_e1509 < 0i));
if (_e1511 >= _e1184) {
phi_2733_ = (_e1184 - 1i);
} else {
phi_2733_ = _e1511;
}
let _e1515 = phi_2733_;
let _e1523 = ((_e1300 + (((_e1485 * _e1179) + _e1470) * _e1174)) + _e1455);
let _e1525 = select(_e1307, _e1523, (_e1523 < _e1307));
let _e1530 = global_3.member[bitcast<u32>(select(0i, _e1525, (_e1525 > 0i)))];
let _e1531 = local_12;
let _e1534 = local_13;
let _e1535 = (_e1523 + _e1534);
let _e1537 = select(_e1307, _e1535, (_e1535 < _e1307));
let _e1542 = global_3.member[bitcast<u32>(select(0i, _e1537, (_e1537 > 0i)))];
let _e1543 = local_12;
let _e1546 = (1f - _e1489);
let _e1548 = (_e1523 + _e1508);
let _e1550 = select(_e1307, _e1548, (_e1548 < _e1307));
let _e1555 = global_3.member[bitcast<u32>(select(0i, _e1550, (_e1550 > 0i)))];
let _e1556 = local_12;
let _e1559 = local_13;
let _e1560 = (_e1548 + _e1559);
let _e1562 = select(_e1307, _e1560, (_e1560 < _e1307));
let _e1567 = global_3.member[bitcast<u32>(select(0i, _e1562, (_e1562 > 0i)))];
let _e1568 = local_12;
let _e1573 = (_e1523 + (((_e1515 - _e1485) * _e1174) * _e1179));
let _e1575 = select(_e1307, _e1573, (_e1573 < _e1307));
let _e1580 = global_3.member[bitcast<u32>(select(0i, _e1575, (_e1575 > 0i)))];
let _e1581 = local_12;
let _e1584 = local_13;
let _e1585 = (_e1573 + _e1584);
let _e1587 = select(_e1307, _e1585, (_e1585 < _e1307));
let _e1592 = global_3.member[bitcast<u32>(select(0i, _e1587, (_e1587 > 0i)))];
let _e1593 = local_12;
let _e1597 = (_e1573 + _e1508);
let _e1599 = select(_e1307, _e1597, (_e1597 < _e1307));
let _e1604 = global_3.member[bitcast<u32>(select(0i, _e1599, (_e1599 > 0i)))];
let _e1605 = local_12;
let _e1608 = local_13;
let _e1609 = (_e1597 + _e1608);
let _e1611 = select(_e1307, _e1609, (_e1609 < _e1307));
let _e1616 = global_3.member[bitcast<u32>(select(0i, _e1611, (_e1611 > 0i)))];
let _e1617 = local_12;
phi_2214_ = (_e1149 + 1u);
phi_2217_ = (_e1151 + ((0.5f * (((((((_e1314 * (1f - _e1315)) + (_e1326 * _e1327)) * _e1330) + (((_e1339 * (1f - _e1340)) + (_e1351 * _e1352)) * _e1266)) * (1f - _e1268)) + (((((_e1364 * (1f - _e1365)) + (_e1376 * _e1377)) * _e1330) + (((_e1388 * (1f - _e1389)) + (_e1400 * _e1401)) * _e1266)) * _e1268)) + ((((((_e1530 * (1f - _e1531)) + (_e1542 * _e1543)) * _e1546) + (((_e1555 * (1f - _e1556)) + (_e1567 * _e1568)) * _e1489)) * (1f - _e1491)) + (((((_e1580 * (1f - _e1581)) + (_e1592 * _e1593)) * _e1546) + (((_e1604 * (1f - _e1605)) + (_e1616 * _e1617)) * _e1489)) * _e1491)))) * _e1161));
} else {
phi_2214_ = u32();
phi_2217_ = f32();
}
let _e1632 = phi_2214_;
let _e1634 = phi_2217_;
continue;
continuing {
phi_2213_ = _e1632;
phi_2216_ = _e1634;
break if !(_e1154);
}
}
let _e10405 = local_68;
phi_2938_ = _e10405;
}
let _e1637 = phi_2938_;
let _e1641 = global_5.member.member_13.member;
let _e1646 = -((_e1641.member * _e1637));
let _e1648 = select(-87f, _e1646, (_e1646 > -87f));
let _e1650 = select(88f, _e1648, (_e1648 < 88f));
let _e1652 = ((_e1650 * 1.442695f) + 0.5f);
let _e1654 = select(-127f, _e1652, (_e1652 > -127f));
let _e1656 = select(128f, _e1654, (_e1654 < 128f));
let _e1663 = select(0i, select(select(i32(_e1656), i32(-2147483648), (_e1656 < -2147483600f)), 2147483647i, (_e1656 > 2147483500f)), (_e1656 == _e1656));
let _e1667 = (_e1663 - select(0i, 1i, (_e1656 < f32(_e1663))));
let _e1668 = f32(_e1667);
let _e1672 = ((_e1650 - (_e1668 * 0.6933594f)) - (_e1668 * -2.1219444e-4f));
let _e1694 = -((_e1641.member_1 * _e1637));
let _e1696 = select(-87f, _e1694, (_e1694 > -87f));
let _e1698 = select(88f, _e1696, (_e1696 < 88f));
let _e1700 = ((_e1698 * 1.442695f) + 0.5f);
let _e1702 = select(-127f, _e1700, (_e1700 > -127f));
let _e1704 = select(128f, _e1702, (_e1702 < 128f));
let _e1711 = select(0i, select(select(i32(_e1704), i32(-2147483648), (_e1704 < -2147483600f)), 2147483647i, (_e1704 > 2147483500f)), (_e1704 == _e1704));
let _e1715 = (_e1711 - select(0i, 1i, (_e1704 < f32(_e1711))));
let _e1716 = f32(_e1715);
let _e1720 = ((_e1698 - (_e1716 * 0.6933594f)) - (_e1716 * -2.1219444e-4f));
let _e1742 = -((_e1641.member_2 * _e1637));
let _e1744 = select(-87f, _e1742, (_e1742 > -87f));
let _e1746 = select(88f, _e1744, (_e1744 < 88f));
let _e1748 = ((_e1746 * 1.442695f) + 0.5f);
let _e1750 = select(-127f, _e1748, (_e1748 > -127f));
let _e1752 = select(128f, _e1750, (_e1750 < 128f));
let _e1759 = select(0i, select(select(i32(_e1752), i32(-2147483648), (_e1752 < -2147483600f)), 2147483647i, (_e1752 > 2147483500f)), (_e1752 == _e1752));
let _e1763 = (_e1759 - select(0i, 1i, (_e1752 < f32(_e1759))));
let _e1764 = f32(_e1763);
let _e1768 = ((_e1746 - (_e1764 * 0.6933594f)) - (_e1764 * -2.1219444e-4f));
let _e1791 = (1f / 3f);
let _e1793 = (1f * ((1f + (_e1672 * (1f + (_e1672 * (0.5f + (_e1672 * (0.16666667f + (_e1672 * (0.041666668f + (_e1672 * (0.008333334f + (_e1672 * (0.001388889f + (_e1672 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1667 + 127i)) << bitcast<u32>(23i)))));
let _e1794 = (1f * ((1f + (_e1720 * (1f + (_e1720 * (0.5f + (_e1720 * (0.16666667f + (_e1720 * (0.041666668f + (_e1720 * (0.008333334f + (_e1720 * (0.001388889f + (_e1720 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1715 + 127i)) << bitcast<u32>(23i)))));
let _e1795 = (1f * ((1f + (_e1768 * (1f + (_e1768 * (0.5f + (_e1768 * (0.16666667f + (_e1768 * (0.041666668f + (_e1768 * (0.008333334f + (_e1768 * (0.001388889f + (_e1768 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1763 + 127i)) << bitcast<u32>(23i)))));
let _e1824 = type_27(_e1086.member, _e1086.member_1, _e1086.member_2, _e1086.member_3, _e1086.member_4, _e1086.member_5, vec3<f32>(_e1793, _e1794, _e1795), _e1086.member_7, _e1086.member_8, _e1086.member_9, _e1086.member_10, _e1086.member_11, _e1086.member_12, _e1086.member_13, _e1086.member_14, _e1086.member_15, _e1086.member_16, _e1086.member_17, _e1086.member_18, _e1086.member_19, _e1086.member_20, _e1086.member_21, _e1086.member_22, _e1086.member_23, _e1086.member_24, _e1086.member_25, _e1086.member_26, _e1086.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e734) {
phi_3166_ = ((((1f + 1f) + 1f) * _e1791) - (((_e1793 + _e1794) + _e1795) * _e1791));
} else {
phi_3166_ = 0f;
}
let _e1833 = phi_3166_;
let _e1862 = type_27(_e1824.member, _e1824.member_1, _e1824.member_2, _e1824.member_3, _e1824.member_4, _e1824.member_5, _e1824.member_6, _e1824.member_7, _e1824.member_8, _e1824.member_9, _e1824.member_10, _e1824.member_11, _e1824.member_12, _e1824.member_13, _e1824.member_14, _e1824.member_15, _e1824.member_16, _e1824.member_17, _e1824.member_18, _e1824.member_19, _e1824.member_20, _e1824.member_21, _e1824.member_22, _e1824.member_23, _e1824.member_24, _e1824.member_25, (_e613 + _e1833), _e1824.member_27);
if _e1033 {
phi_3193_ = type_27(_e1862.member, _e1862.member_1, _e1862.member_2, _e1862.member_3, _e1862.member_4, _e1862.member_5, _e1862.member_6, _e1862.member_7, (bitcast<i32>(_e142) / 8i), _e1862.member_9, _e1862.member_10, _e1862.member_11, _e1862.member_12, _e1862.member_13, _e1862.member_14, _e1862.member_15, _e1862.member_16, _e1862.member_17, _e1862.member_18, _e1862.member_19, _e1862.member_20, _e1862.member_21, _e1862.member_22, _e1862.member_23, _e1862.member_24, _e1862.member_25, _e1862.member_26, _e1862.member_27);
} else {
phi_3193_ = _e1862;
}
let _e1894 = phi_3193_;
phi_3194_ = _e1894;
} else {
phi_3194_ = type_27(vec3<f32>(_e174, _e184, _e195), vec3<f32>(_e206, _e217, _e228), vec3<f32>(_e239, _e250, _e261), vec3<f32>(_e272, _e283, _e294), vec3<f32>(_e305, _e316, _e327), vec3<f32>(_e338, _e349, _e360), vec3<f32>(_e371, _e382, _e393), select(0i, select(select(i32(_e404), i32(-2147483648), (_e404 < -2147483600f)), 2147483647i, (_e404 > 2147483500f)), (_e404 == _e404)), select(0i, select(select(i32(_e415), i32(-2147483648), (_e415 < -2147483600f)), 2147483647i, (_e415 > 2147483500f)), (_e415 == _e415)), select(0i, select(select(i32(_e426), i32(-2147483648), (_e426 < -2147483600f)), 2147483647i, (_e426 > 2147483500f)), (_e426 == _e426)), _e437, select(0i, select(select(i32(_e448), i32(-2147483648), (_e448 < -2147483600f)), 2147483647i, (_e448 > 2147483500f)), (_e448 == _e448)), select(0i, select(select(i32(_e459), i32(-2147483648), (_e459 < -2147483600f)), 2147483647i, (_e459 > 2147483500f)), (_e459 == _e459)), _e470, _e481, _e492, select(0i, select(select(i32(_e503), i32(-2147483648), (_e503 < -2147483600f)), 2147483647i, (_e503 > 2147483500f)), (_e503 == _e503)), _e713, _e720, _e727, _e734, _e741, _e631, _e580, _e591, _e602, _e613, _e624);
}
let _e1896 = phi_3194_;
let _e1897 = bitcast<i32>(_e142);
let _e1898 = (_e1897 / 8i);
let _e1900 = (_e1896.member_15 == 2f);
if _e1900 {
phi_3214_ = type_27(_e1896.member, _e1896.member_1, _e1896.member_2, _e1896.member_3, _e1896.member_4, _e1896.member_5, _e1896.member_6, _e1896.member_7, _e1896.member_8, _e1896.member_9, _e1896.member_10, _e1896.member_11, _e1896.member_12, _e1896.member_13, _e1896.member_14, 1f, _e1896.member_16, _e1896.member_17, _e1896.member_18, _e1896.member_19, _e1896.member_20, _e1896.member_21, _e1896.member_22, _e1896.member_23, _e1896.member_24, _e1896.member_25, _e1896.member_26, _e1896.member_27);
} else {
phi_3214_ = _e1896;
}
let _e1930 = phi_3214_;
phi_3216_ = _e1930;
phi_3219_ = 0i;
phi_3221_ = _e1900;
loop {
let _e1932 = phi_3216_;
let _e1934 = phi_3219_;
let _e1936 = phi_3221_;
local_26 = _e1932;
local_27 = _e1932;
local_28 = _e1932;
local_29 = _e1932;
local_30 = _e1932;
local_31 = _e1932;
local_32 = _e1932;
local_33 = _e1932;
local_34 = _e1932;
local_35 = _e1932;
local_36 = _e1932;
local_37 = _e1932;
local_38 = _e1932;
local_39 = _e1932;
local_40 = _e1932;
local_41 = _e1932;
local_42 = _e1932;
local_43 = _e1932;
local_44 = _e1932;
local_45 = _e1932;
local_46 = _e1932;
local_47 = _e1932;
local_48 = _e1932;
local_49 = _e1932;
local_50 = _e1932;
local_51 = _e1932;
local_52 = _e1932;
local_53 = _e1932;
local_54 = _e1932;
local_55 = _e1932;
local_56 = _e1932;
local_57 = _e1932;
local_58 = _e1932;
local_59 = _e1932;
local_60 = _e1932;
local_61 = _e1932;
local_62 = _e1932;
local_63 = _e1932;
local_64 = _e1932;
local_65 = _e1932;
local_66 = _e1932;
let _e1940 = ((_e1934 < 1024i) && (_e1932.member_15 == 1f));
local_67 = _e1932.member_15;
if _e1940 {
if (_e1932.member_8 < _e1898) {
let _e9292 = f32(_e1932.member_11);
let _e9294 = f32(_e1932.member_12);
let _e9296 = vec3<f32>(_e9292, _e9294, _e1932.member_13);
let _e9298 = (_e1932.member_9 >= 0i);
if _e9298 {
let _e9299 = (_e1932.member_9 * 19i);
let _e9301 = (bitcast<i32>(_e144) - 1i);
let _e9303 = select(_e9301, _e9299, (_e9299 < _e9301));
let _e9309 = global_2.member[bitcast<u32>(select(0i, _e9303, (_e9303 > 0i)))];
let _e9310 = (_e9299 + 1i);
let _e9312 = select(_e9301, _e9310, (_e9310 < _e9301));
let _e9318 = global_2.member[bitcast<u32>(select(0i, _e9312, (_e9312 > 0i)))];
let _e9319 = (_e9299 + 2i);
let _e9321 = select(_e9301, _e9319, (_e9319 < _e9301));
let _e9327 = global_2.member[bitcast<u32>(select(0i, _e9321, (_e9321 > 0i)))];
let _e9328 = (_e9299 + 3i);
let _e9330 = select(_e9301, _e9328, (_e9328 < _e9301));
let _e9336 = global_2.member[bitcast<u32>(select(0i, _e9330, (_e9330 > 0i)))];
let _e9337 = (_e9299 + 4i);
let _e9339 = select(_e9301, _e9337, (_e9337 < _e9301));
let _e9345 = global_2.member[bitcast<u32>(select(0i, _e9339, (_e9339 > 0i)))];
let _e9346 = (_e9299 + 5i);
let _e9348 = select(_e9301, _e9346, (_e9346 < _e9301));
let _e9354 = global_2.member[bitcast<u32>(select(0i, _e9348, (_e9348 > 0i)))];
let _e9355 = (_e9336 - _e9309);
let _e9356 = (_e9345 - _e9318);
let _e9357 = (_e9354 - _e9327);
let _e9358 = (_e9299 + 6i);
let _e9360 = select(_e9301, _e9358, (_e9358 < _e9301));
let _e9366 = global_2.member[bitcast<u32>(select(0i, _e9360, (_e9360 > 0i)))];
let _e9367 = (_e9299 + 7i);
let _e9369 = select(_e9301, _e9367, (_e9367 < _e9301));
let _e9375 = global_2.member[bitcast<u32>(select(0i, _e9369, (_e9369 > 0i)))];
let _e9376 = (_e9299 + 8i);
let _e9378 = select(_e9301, _e9376, (_e9376 < _e9301));
let _e9384 = global_2.member[bitcast<u32>(select(0i, _e9378, (_e9378 > 0i)))];
let _e9385 = (_e9366 - _e9309);
let _e9386 = (_e9375 - _e9318);
let _e9387 = (_e9384 - _e9327);
let _e9390 = ((_e9356 * _e9387) - (_e9357 * _e9386));
let _e9393 = ((_e9357 * _e9385) - (_e9355 * _e9387));
let _e9396 = ((_e9355 * _e9386) - (_e9356 * _e9385));
let _e9401 = (((_e9390 * _e9390) + (_e9393 * _e9393)) + (_e9396 * _e9396));
let _e9404 = sqrt(select(0f, _e9401, (_e9401 > 0f)));
let _e9407 = (1f / select(1e-20f, _e9404, (_e9404 > 1e-20f)));
phi_3447_ = (((_e1932.member_1.x * (_e9390 * _e9407)) + (_e1932.member_1.y * (_e9393 * _e9407))) + (_e1932.member_1.z * (_e9396 * _e9407)));
} else {
phi_3447_ = 1f;
}
let _e9420 = phi_3447_;
let _e9427 = select(0i, select(select(i32(_e9292), i32(-2147483648), (_e9292 < -2147483600f)), 2147483647i, (_e9292 > 2147483500f)), (_e9292 == _e9292));
let _e9434 = select(0i, select(select(i32(_e9294), i32(-2147483648), (_e9294 < -2147483600f)), 2147483647i, (_e9294 > 2147483500f)), (_e9294 == _e9294));
let _e9437 = bitcast<f32>((bitcast<u32>(_e9420) & 2147483647u));
let _e9439 = select(1e-3f, _e9437, (_e9437 > 1e-3f));
let _e9440 = type_28(_e9427, _e9434, _e1932.member_13, _e1932.member_14, _e9439);
let _e9445 = global_5.member.member_12.member;
let _e9448 = (_e1932.member_10 + select(0f, (_e9445 / _e9439), _e9298));
let _e9452 = (_e1932.member_8 * 8i);
let _e9455 = bitcast<f32>((bitcast<u32>(_e1932.member_1.x) & 2147483647u));
let _e9460 = (1f / select(_e1932.member_1.x, select(1e-12f, -1e-12f, (_e1932.member_1.x < 0f)), (_e9455 < 1e-12f)));
let _e9463 = bitcast<f32>((bitcast<u32>(_e1932.member_1.y) & 2147483647u));
let _e9468 = (1f / select(_e1932.member_1.y, select(1e-12f, -1e-12f, (_e1932.member_1.y < 0f)), (_e9463 < 1e-12f)));
let _e9471 = bitcast<f32>((bitcast<u32>(_e1932.member_1.z) & 2147483647u));
let _e9476 = (1f / select(_e1932.member_1.z, select(1e-12f, -1e-12f, (_e1932.member_1.z < 0f)), (_e9471 < 1e-12f)));
let _e9477 = (_e1897 - 1i);
let _e9479 = select(_e9477, _e9452, (_e9452 < _e9477));
let _e9485 = global_1.member[bitcast<u32>(select(0i, _e9479, (_e9479 > 0i)))];
let _e9486 = (_e9452 + 1i);
let _e9488 = select(_e9477, _e9486, (_e9486 < _e9477));
let _e9494 = global_1.member[bitcast<u32>(select(0i, _e9488, (_e9488 > 0i)))];
let _e9495 = (_e9452 + 2i);
let _e9497 = select(_e9477, _e9495, (_e9495 < _e9477));
let _e9503 = global_1.member[bitcast<u32>(select(0i, _e9497, (_e9497 > 0i)))];
let _e9504 = (_e9452 + 3i);
let _e9506 = select(_e9477, _e9504, (_e9504 < _e9477));
let _e9512 = global_1.member[bitcast<u32>(select(0i, _e9506, (_e9506 > 0i)))];
let _e9513 = (_e9452 + 4i);
let _e9515 = select(_e9477, _e9513, (_e9513 < _e9477));
let _e9521 = global_1.member[bitcast<u32>(select(0i, _e9515, (_e9515 > 0i)))];
let _e9522 = (_e9452 + 5i);
let _e9524 = select(_e9477, _e9522, (_e9522 < _e9477));
let _e9530 = global_1.member[bitcast<u32>(select(0i, _e9524, (_e9524 > 0i)))];
let _e9533 = ((_e9485 - _e1932.member.x) * _e9460);
let _e9535 = ((_e9512 - _e1932.member.x) * _e9460);
let _e9538 = ((_e9494 - _e1932.member.y) * _e9468);
let _e9540 = ((_e9521 - _e1932.member.y) * _e9468);
let _e9543 = ((_e9503 - _e1932.member.z) * _e9476);
let _e9545 = ((_e9530 - _e1932.member.z) * _e9476);
let _e9547 = select(_e9535, _e9533, (_e9533 < _e9535));
let _e9549 = select(_e9540, _e9538, (_e9538 < _e9540));
let _e9551 = select(_e9549, _e9547, (_e9547 > _e9549));
let _e9553 = select(_e9545, _e9543, (_e9543 < _e9545));
let _e9557 = select(_e9535, _e9533, (_e9533 > _e9535));
let _e9559 = select(_e9540, _e9538, (_e9538 > _e9540));
let _e9561 = select(_e9559, _e9557, (_e9557 < _e9559));
let _e9563 = select(_e9545, _e9543, (_e9543 > _e9545));
let _e9565 = select(_e9563, _e9561, (_e9561 < _e9563));
let _e9570 = ((select(_e9553, _e9551, (_e9551 > _e9553)) <= select(_e9448, _e9565, (_e9565 < _e9448))) && (_e9565 >= _e1932.member_13));
let _e9571 = (_e9452 + 6i);
let _e9573 = select(_e9477, _e9571, (_e9571 < _e9477));
let _e9579 = global_1.member[bitcast<u32>(select(0i, _e9573, (_e9573 > 0i)))];
if _e9570 {
phi_3760_ = (_e1932.member_8 + 1i);
} else {
let _e9587 = (_e9452 + 7i);
let _e9589 = select(_e9477, _e9587, (_e9587 < _e9477));
let _e9595 = global_1.member[bitcast<u32>(select(0i, _e9589, (_e9589 > 0i)))];
phi_3760_ = select(0i, select(select(i32(_e9595), i32(-2147483648), (_e9595 < -2147483600f)), 2147483647i, (_e9595 > 2147483500f)), (_e9595 == _e9595));
}
let _e9605 = phi_3760_;
let _e9606 = type_19(_e1932.member, _e1932.member_1, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), _e9296, _e1932.member_14, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, _e9605, _e1932.member_9, _e1932.member_10);
let _e9607 = select(-1i, select(0i, select(select(i32(_e9579), i32(-2147483648), (_e9579 < -2147483600f)), 2147483647i, (_e9579 > 2147483500f)), (_e9579 == _e9579)), _e9570);
if (_e9607 < 0i) {
phi_4540_ = type_28();
phi_4541_ = type_19();
phi_4542_ = true;
} else {
let _e9611 = ((_e9455 >= _e9463) && (_e9455 >= _e9471));
let _e9614 = (!(_e9611) && (_e9463 >= _e9471));
let _e9621 = (1f / select(select(_e1932.member_1.z, _e1932.member_1.y, _e9614), _e1932.member_1.x, _e9611));
let _e9622 = (select(select(_e1932.member_1.x, _e1932.member_1.z, _e9614), _e1932.member_1.y, _e9611) * _e9621);
let _e9623 = (select(select(_e1932.member_1.y, _e1932.member_1.x, _e9614), _e1932.member_1.z, _e9611) * _e9621);
let _e9624 = (_e9607 * 19i);
let _e9626 = (bitcast<i32>(_e144) - 1i);
let _e9628 = select(_e9626, _e9624, (_e9624 < _e9626));
let _e9634 = global_2.member[bitcast<u32>(select(0i, _e9628, (_e9628 > 0i)))];
let _e9635 = (_e9624 + 1i);
let _e9637 = select(_e9626, _e9635, (_e9635 < _e9626));
let _e9643 = global_2.member[bitcast<u32>(select(0i, _e9637, (_e9637 > 0i)))];
let _e9644 = (_e9624 + 2i);
let _e9646 = select(_e9626, _e9644, (_e9644 < _e9626));
let _e9652 = global_2.member[bitcast<u32>(select(0i, _e9646, (_e9646 > 0i)))];
let _e9653 = (_e9634 - _e1932.member.x);
let _e9654 = (_e9643 - _e1932.member.y);
let _e9655 = (_e9652 - _e1932.member.z);
let _e9661 = select(select(_e9655, _e9654, _e9614), _e9653, _e9611);
let _e9663 = (select(select(_e9653, _e9655, _e9614), _e9654, _e9611) - (_e9622 * _e9661));
let _e9665 = (select(select(_e9654, _e9653, _e9614), _e9655, _e9611) - (_e9623 * _e9661));
let _e9667 = (_e9624 + 3i);
let _e9669 = select(_e9626, _e9667, (_e9667 < _e9626));
let _e9675 = global_2.member[bitcast<u32>(select(0i, _e9669, (_e9669 > 0i)))];
let _e9676 = (_e9624 + 4i);
let _e9678 = select(_e9626, _e9676, (_e9676 < _e9626));
let _e9684 = global_2.member[bitcast<u32>(select(0i, _e9678, (_e9678 > 0i)))];
let _e9685 = (_e9624 + 5i);
let _e9687 = select(_e9626, _e9685, (_e9685 < _e9626));
let _e9693 = global_2.member[bitcast<u32>(select(0i, _e9687, (_e9687 > 0i)))];
let _e9694 = (_e9675 - _e1932.member.x);
let _e9695 = (_e9684 - _e1932.member.y);
let _e9696 = (_e9693 - _e1932.member.z);
let _e9702 = select(select(_e9696, _e9695, _e9614), _e9694, _e9611);
let _e9704 = (select(select(_e9694, _e9696, _e9614), _e9695, _e9611) - (_e9622 * _e9702));
let _e9706 = (select(select(_e9695, _e9694, _e9614), _e9696, _e9611) - (_e9623 * _e9702));
let _e9708 = (_e9624 + 6i);
let _e9710 = select(_e9626, _e9708, (_e9708 < _e9626));
let _e9716 = global_2.member[bitcast<u32>(select(0i, _e9710, (_e9710 > 0i)))];
let _e9717 = (_e9624 + 7i);
let _e9719 = select(_e9626, _e9717, (_e9717 < _e9626));
let _e9725 = global_2.member[bitcast<u32>(select(0i, _e9719, (_e9719 > 0i)))];
let _e9726 = (_e9624 + 8i);
let _e9728 = select(_e9626, _e9726, (_e9726 < _e9626));
let _e9734 = global_2.member[bitcast<u32>(select(0i, _e9728, (_e9728 > 0i)))];
let _e9735 = (_e9716 - _e1932.member.x);
let _e9736 = (_e9725 - _e1932.member.y);
let _e9737 = (_e9734 - _e1932.member.z);
let _e9743 = select(select(_e9737, _e9736, _e9614), _e9735, _e9611);
let _e9745 = (select(select(_e9735, _e9737, _e9614), _e9736, _e9611) - (_e9622 * _e9743));
let _e9747 = (select(select(_e9736, _e9735, _e9614), _e9737, _e9611) - (_e9623 * _e9743));
let _e9751 = ((_e9745 * _e9706) - (_e9747 * _e9704));
let _e9754 = ((_e9663 * _e9747) - (_e9665 * _e9745));
let _e9757 = ((_e9704 * _e9665) - (_e9706 * _e9663));
let _e9759 = ((_e9751 + _e9754) + _e9757);
let _e9773 = (!(((((_e9751 < 0f) || (_e9754 < 0f)) || (_e9757 < 0f)) && (((_e9751 > 0f) || (_e9754 > 0f)) || (_e9757 > 0f)))) && (_e9759 != 0f));
let _e9781 = select(1e30f, ((((_e9751 * (_e9661 * _e9621)) + (_e9754 * (_e9702 * _e9621))) + (_e9757 * (_e9743 * _e9621))) / select(1f, _e9759, _e9773)), _e9773);
if (_e9781 >= _e9448) {
phi_4534_ = type_28();
phi_4535_ = type_19();
phi_4536_ = true;
} else {
let _e9783 = (_e9675 - _e9634);
let _e9784 = (_e9684 - _e9643);
let _e9785 = (_e9693 - _e9652);
let _e9786 = (_e9716 - _e9634);
let _e9787 = (_e9725 - _e9643);
let _e9788 = (_e9734 - _e9652);
let _e9791 = ((_e9784 * _e9788) - (_e9785 * _e9787));
let _e9794 = ((_e9785 * _e9786) - (_e9783 * _e9788));
let _e9797 = ((_e9783 * _e9787) - (_e9784 * _e9786));
let _e9802 = (((_e9791 * _e9791) + (_e9794 * _e9794)) + (_e9797 * _e9797));
let _e9805 = sqrt(select(0f, _e9802, (_e9802 > 0f)));
let _e9808 = (1f / select(1e-20f, _e9805, (_e9805 > 1e-20f)));
let _e9816 = (((_e1932.member_1.x * (_e9791 * _e9808)) + (_e1932.member_1.y * (_e9794 * _e9808))) + (_e1932.member_1.z * (_e9797 * _e9808)));
let _e9819 = bitcast<f32>((bitcast<u32>(_e9816) & 2147483647u));
let _e9821 = select(1e-3f, _e9819, (_e9819 > 1e-3f));
let _e9822 = (_e9624 + 18i);
let _e9824 = select(_e9626, _e9822, (_e9822 < _e9626));
let _e9830 = global_2.member[bitcast<u32>(select(0i, _e9824, (_e9824 > 0i)))];
let _e9837 = select(0i, select(select(i32(_e9830), i32(-2147483648), (_e9830 < -2147483600f)), 2147483647i, (_e9830 > 2147483500f)), (_e9830 == _e9830));
let _e9838 = (_e9837 * 4i);
let _e9840 = (bitcast<i32>(_e147) - 1i);
let _e9842 = select(_e9840, _e9838, (_e9838 < _e9840));
let _e9848 = global_3.member[bitcast<u32>(select(0i, _e9842, (_e9842 > 0i)))];
let _e9850 = select(_e9848, 1f, (_e9837 == 16i));
let _e9851 = (_e9850 <= 0f);
if _e9851 {
phi_4371_ = 0i;
} else {
phi_4371_ = (1i << bitcast<u32>((_e9837 & 31i)));
}
let _e9856 = phi_4371_;
let _e9857 = (_e9816 < 0f);
let _e9858 = select(_e9856, 0i, _e9857);
let _e9859 = select(0i, _e9856, _e9857);
let _e9868 = (_e9781 * _e9821);
let _e9881 = (((_e9781 > _e1932.member_13) && (_e1932.member_13 > 0f)) || (((_e9868 > (_e9445 * 2f)) || ((((_e9850 == 0f) || ((_e9859 & ~(_e1932.member_7)) != 0i)) || ((_e9858 & _e1932.member_7) != 0i)) && (_e9868 >= -((_e9445 * 0.5f))))) && (_e1932.member_13 <= 0f)));
if _e9881 {
let _e9882 = (_e9781 < _e1932.member_10);
if (_e9298 && ((bitcast<f32>((bitcast<u32>((_e9781 - _e1932.member_10)) & 2147483647u)) * select(_e9439, _e9821, (_e9821 > _e9439))) <= _e9445)) {
let _e9901 = ((_e1932.member_9 * 19i) + 18i);
let _e9903 = select(_e9626, _e9901, (_e9901 < _e9626));
let _e9909 = global_2.member[bitcast<u32>(select(0i, _e9903, (_e9903 > 0i)))];
let _e9916 = select(0i, select(select(i32(_e9909), i32(-2147483648), (_e9909 < -2147483600f)), 2147483647i, (_e9909 > 2147483500f)), (_e9909 == _e9909));
let _e9917 = (_e9916 * 4i);
let _e9919 = select(_e9840, _e9917, (_e9917 < _e9840));
let _e9925 = global_3.member[bitcast<u32>(select(0i, _e9919, (_e9919 > 0i)))];
if (_e9851 != (select(_e9925, 1f, (_e9916 == 16i)) <= 0f)) {
phi_4516_ = _e9851;
} else {
if (!(_e9851) && (_e9837 != _e9916)) {
phi_4515_ = (_e9837 < _e9916);
} else {
phi_4515_ = _e9882;
}
let _e9935 = phi_4515_;
phi_4516_ = _e9935;
}
let _e9937 = phi_4516_;
phi_4522_ = type_28((_e9427 | _e9859), (_e9434 | _e9858), _e1932.member_13, select(_e9781, _e1932.member_14, (_e1932.member_14 > _e9781)), _e9439);
phi_4523_ = _e9937;
} else {
if _e9882 {
phi_4521_ = type_28(_e9859, _e9858, _e1932.member_13, _e9781, _e9439);
} else {
phi_4521_ = _e9440;
}
let _e9894 = phi_4521_;
phi_4522_ = _e9894;
phi_4523_ = _e9882;
}
let _e9939 = phi_4522_;
let _e9941 = phi_4523_;
if _e9941 {
phi_4530_ = type_19(_e1932.member, _e1932.member_1, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), _e9296, _e1932.member_14, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, _e9605, _e9607, _e9781);
} else {
phi_4530_ = _e9606;
}
let _e9944 = phi_4530_;
phi_4531_ = _e9939;
phi_4532_ = _e9944;
} else {
phi_4531_ = type_28();
phi_4532_ = type_19();
}
let _e9946 = phi_4531_;
let _e9948 = phi_4532_;
phi_4534_ = _e9946;
phi_4535_ = _e9948;
phi_4536_ = select(true, false, _e9881);
}
let _e9951 = phi_4534_;
let _e9953 = phi_4535_;
let _e9955 = phi_4536_;
phi_4540_ = _e9951;
phi_4541_ = _e9953;
phi_4542_ = _e9955;
}
let _e9957 = phi_4540_;
let _e9959 = phi_4541_;
let _e9961 = phi_4542_;
if _e9961 {
phi_4546_ = _e9440;
phi_4547_ = _e9606;
} else {
phi_4546_ = _e9957;
phi_4547_ = _e9959;
}
let _e9963 = phi_4546_;
let _e9965 = phi_4547_;
let _e9994 = type_27(_e1932.member, _e1932.member_1, _e1932.member_2, _e1932.member_3, _e1932.member_4, _e1932.member_5, _e1932.member_6, _e1932.member_7, _e9965.member_15, _e1932.member_9, _e1932.member_10, _e1932.member_11, _e1932.member_12, _e1932.member_13, _e1932.member_14, _e1932.member_15, _e1932.member_16, _e1932.member_17, _e1932.member_18, _e1932.member_19, _e1932.member_20, _e1932.member_21, _e1932.member_22, _e1932.member_23, _e1932.member_24, _e1932.member_25, _e1932.member_26, _e1932.member_27);
let _e10023 = type_27(_e9994.member, _e9994.member_1, _e9994.member_2, _e9994.member_3, _e9994.member_4, _e9994.member_5, _e9994.member_6, _e9994.member_7, _e9994.member_8, _e9965.member_16, _e9994.member_10, _e9994.member_11, _e9994.member_12, _e9994.member_13, _e9994.member_14, _e9994.member_15, _e9994.member_16, _e9994.member_17, _e9994.member_18, _e9994.member_19, _e9994.member_20, _e9994.member_21, _e9994.member_22, _e9994.member_23, _e9994.member_24, _e9994.member_25, _e9994.member_26, _e9994.member_27);
let _e10052 = type_27(_e10023.member, _e10023.member_1, _e10023.member_2, _e10023.member_3, _e10023.member_4, _e10023.member_5, _e10023.member_6, _e10023.member_7, _e10023.member_8, _e10023.member_9, _e9965.member_17, _e10023.member_11, _e10023.member_12, _e10023.member_13, _e10023.member_14, _e10023.member_15, _e10023.member_16, _e10023.member_17, _e10023.member_18, _e10023.member_19, _e10023.member_20, _e10023.member_21, _e10023.member_22, _e10023.member_23, _e10023.member_24, _e10023.member_25, _e10023.member_26, _e10023.member_27);
let _e10081 = type_27(_e10052.member, _e10052.member_1, _e10052.member_2, _e10052.member_3, _e10052.member_4, _e10052.member_5, _e10052.member_6, _e10052.member_7, _e10052.member_8, _e10052.member_9, _e10052.member_10, _e9963.member, _e10052.member_12, _e10052.member_13, _e10052.member_14, _e10052.member_15, _e10052.member_16, _e10052.member_17, _e10052.member_18, _e10052.member_19, _e10052.member_20, _e10052.member_21, _e10052.member_22, _e10052.member_23, _e10052.member_24, _e10052.member_25, _e10052.member_26, _e10052.member_27);
let _e10110 = type_27(_e10081.member, _e10081.member_1, _e10081.member_2, _e10081.member_3, _e10081.member_4, _e10081.member_5, _e10081.member_6, _e10081.member_7, _e10081.member_8, _e10081.member_9, _e10081.member_10, _e10081.member_11, _e9963.member_1, _e10081.member_13, _e10081.member_14, _e10081.member_15, _e10081.member_16, _e10081.member_17, _e10081.member_18, _e10081.member_19, _e10081.member_20, _e10081.member_21, _e10081.member_22, _e10081.member_23, _e10081.member_24, _e10081.member_25, _e10081.member_26, _e10081.member_27);
phi_12424_ = type_27(_e10110.member, _e10110.member_1, _e10110.member_2, _e10110.member_3, _e10110.member_4, _e10110.member_5, _e10110.member_6, _e10110.member_7, _e10110.member_8, _e10110.member_9, _e10110.member_10, _e10110.member_11, _e10110.member_12, _e10110.member_13, _e9963.member_3, _e10110.member_15, _e10110.member_16, _e10110.member_17, _e10110.member_18, _e10110.member_19, _e10110.member_20, _e10110.member_21, _e10110.member_22, _e10110.member_23, _e10110.member_24, _e10110.member_25, _e10110.member_26, _e10110.member_27);
phi_12425_ = _e1936;
} else {
phi_4562_ = 15i;
phi_4565_ = 16i;
loop {
let _e1946 = phi_4562_;
let _e1948 = phi_4565_;
local_16 = _e1948;
local_17 = _e1948;
local_18 = _e1948;
local_20 = _e1948;
local_23 = _e1948;
let _e1949 = (_e1946 >= 0i);
if _e1949 {
phi_4563_ = (_e1946 - 1i);
phi_4566_ = select(_e1948, _e1946, (((_e1932.member_7 >> bitcast<u32>((_e1946 & 31i))) & 1i) == 1i));
} else {
phi_4563_ = i32();
phi_4566_ = i32();
}
let _e1958 = phi_4563_;
let _e1960 = phi_4566_;
continue;
continuing {
phi_4562_ = _e1958;
phi_4565_ = _e1960;
break if !(_e1949);
}
}
let _e1963 = local_16;
let _e1964 = (_e1963 == 16i);
let _e1976 = (bitcast<i32>(countOneBits(bitcast<u32>((_e1932.member_17 & ((1i << bitcast<u32>((_e1932.member_16 & 31i))) - 1i))))) == _e1932.member_20);
let _e1979 = ((_e1964 && _e1976) && !(_e1936));
if _e1979 {
let _e9253 = type_27(_e1932.member, _e1932.member_1, _e1932.member_2, _e1932.member_3, _e1932.member_4, _e1932.member_5, _e1932.member_6, _e1932.member_7, _e1932.member_8, _e1932.member_9, _e1932.member_10, _e1932.member_11, _e1932.member_12, _e1932.member_13, _e1932.member_14, 2f, _e1932.member_16, _e1932.member_17, _e1932.member_18, _e1932.member_19, _e1932.member_20, _e1932.member_21, _e1932.member_22, _e1932.member_23, _e1932.member_24, _e1932.member_25, _e1932.member_26, _e1932.member_27);
phi_12422_ = type_27(_e9253.member, _e9253.member_1, _e9253.member_2, _e9253.member_3, _e9253.member_4, _e9253.member_5, _e9253.member_6, _e9253.member_7, _e9253.member_8, _e9253.member_9, _e9253.member_10, _e9253.member_11, _e9253.member_12, _e9253.member_13, _e9253.member_14, _e9253.member_15, _e9253.member_16, _e9253.member_17, _e9253.member_18, _e9253.member_19, _e9253.member_20, _e9253.member_21, (_e1932.member_22 + 1i), _e9253.member_23, _e9253.member_24, _e9253.member_25, _e9253.member_26, _e9253.member_27);
} else {
let _e1981 = (_e1932.member_9 >= 0i);
let _e1984 = (_e1932.member_10 - _e1932.member_13);
let _e1986 = select(0f, _e1984, (_e1984 > 0f));
let _e1989 = ((select(0i, _e1932.member_9, _e1981) * 19i) + 18i);
let _e1991 = (bitcast<i32>(_e144) - 1i);
let _e1993 = select(_e1991, _e1989, (_e1989 < _e1991));
let _e1999 = global_2.member[bitcast<u32>(select(0i, _e1993, (_e1993 > 0i)))];
let _e2006 = select(0i, select(select(i32(_e1999), i32(-2147483648), (_e1999 < -2147483600f)), 2147483647i, (_e1999 > 2147483500f)), (_e1999 == _e1999));
let _e2007 = (_e2006 * 4i);
let _e2009 = (bitcast<i32>(_e147) - 1i);
let _e2011 = select(_e2009, _e2007, (_e2007 < _e2009));
let _e2017 = global_3.member[bitcast<u32>(select(0i, _e2011, (_e2011 > 0i)))];
let _e2019 = select(_e2017, 1f, (_e2006 == 16i));
let _e2021 = (_e1981 && (_e2019 <= 0f));
let _e2030 = ((_e1932.member_7 | (_e1932.member_11 & ~(_e1932.member_12))) & ~((_e1932.member_12 & ~(_e1932.member_11))));
phi_4684_ = 15i;
phi_4687_ = 16i;
loop {
let _e2032 = phi_4684_;
let _e2034 = phi_4687_;
local_19 = _e2034;
local_21 = _e2034;
local_22 = _e2034;
local_24 = _e2034;
local_25 = _e2034;
let _e2035 = (_e2032 >= 0i);
if _e2035 {
phi_4685_ = (_e2032 - 1i);
phi_4688_ = select(_e2034, _e2032, (((_e2030 >> bitcast<u32>((_e2032 & 31i))) & 1i) == 1i));
} else {
phi_4685_ = i32();
phi_4688_ = i32();
}
let _e2044 = phi_4685_;
let _e2046 = phi_4688_;
continue;
continuing {
phi_4684_ = _e2044;
phi_4687_ = _e2046;
break if !(_e2035);
}
}
if _e1964 {
let _e2316 = (1f / select(_e1932.member_1.x, select(1e-12f, -1e-12f, (_e1932.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e1932.member_1.x) & 2147483647u)) < 1e-12f)));
let _e2325 = (1f / select(_e1932.member_1.y, select(1e-12f, -1e-12f, (_e1932.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e1932.member_1.y) & 2147483647u)) < 1e-12f)));
let _e2334 = (1f / select(_e1932.member_1.z, select(1e-12f, -1e-12f, (_e1932.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e1932.member_1.z) & 2147483647u)) < 1e-12f)));
let _e2338 = global_5.member.member_13.member_4;
let _e2345 = global_5.member.member_13.member_5;
let _e2351 = ((_e2338.member - _e1932.member.x) * _e2316);
let _e2353 = ((_e2345.member - _e1932.member.x) * _e2316);
let _e2356 = ((_e2338.member_1 - _e1932.member.y) * _e2325);
let _e2358 = ((_e2345.member_1 - _e1932.member.y) * _e2325);
let _e2361 = ((_e2338.member_2 - _e1932.member.z) * _e2334);
let _e2363 = ((_e2345.member_2 - _e1932.member.z) * _e2334);
let _e2365 = select(_e2353, _e2351, (_e2351 < _e2353));
let _e2367 = select(_e2358, _e2356, (_e2356 < _e2358));
let _e2369 = select(_e2367, _e2365, (_e2365 > _e2367));
let _e2371 = select(_e2363, _e2361, (_e2361 < _e2363));
let _e2373 = select(_e2371, _e2369, (_e2369 > _e2371));
let _e2375 = select(_e2353, _e2351, (_e2351 > _e2353));
let _e2377 = select(_e2358, _e2356, (_e2356 > _e2358));
let _e2379 = select(_e2377, _e2375, (_e2375 < _e2377));
let _e2381 = select(_e2363, _e2361, (_e2361 > _e2363));
let _e2383 = select(_e2381, _e2379, (_e2379 < _e2381));
let _e2385 = select(0f, _e2373, (_e2373 > 0f));
let _e2387 = select(_e1932.member_10, _e2383, (_e2383 < _e1932.member_10));
let _e2388 = (_e2387 > _e2385);
let _e2389 = select(0f, _e2385, _e2388);
let _e2391 = (select(0f, _e2387, _e2388) - _e2389);
let _e2395 = global_5.member.member_13.member_6;
if (_e2395 == 0u) {
phi_5591_ = _e2391;
} else {
let _e2398 = (_e2391 / f32(_e2395));
phi_4866_ = 0u;
phi_4869_ = 0f;
loop {
let _e2400 = phi_4866_;
let _e2402 = phi_4869_;
local_69 = _e2402;
let _e2405 = ((_e2400 < _e2395) && (_e2391 > 0f));
if _e2405 {
let _e2408 = (_e2389 + (_e2398 * f32(_e2400)));
let _e2409 = (_e2408 + _e2398);
let _e2411 = (0.5f * (_e2408 + _e2409));
let _e2412 = (_e2409 - _e2408);
let _e2413 = (0.28867513f * _e2412);
let _e2414 = (_e2411 - _e2413);
let _e2424 = global_5.member.member_13.member_7;
let _e2425 = bitcast<i32>(_e2424);
let _e2429 = global_5.member.member_13.member_8;
let _e2430 = bitcast<i32>(_e2429);
let _e2434 = global_5.member.member_13.member_9;
let _e2435 = bitcast<i32>(_e2434);
let _e2436 = f32(_e2425);
let _e2438 = (_e2345.member - _e2338.member);
let _e2441 = (((((_e1932.member.x + (_e1932.member_1.x * _e2414)) - _e2338.member) / _e2438) * _e2436) - 0.5f);
let _e2442 = (_e2436 - 1f);
let _e2444 = select(0f, _e2441, (_e2441 > 0f));
let _e2446 = select(_e2442, _e2444, (_e2444 < _e2442));
let _e2447 = f32(_e2430);
let _e2449 = (_e2345.member_1 - _e2338.member_1);
let _e2452 = (((((_e1932.member.y + (_e1932.member_1.y * _e2414)) - _e2338.member_1) / _e2449) * _e2447) - 0.5f);
let _e2453 = (_e2447 - 1f);
let _e2455 = select(0f, _e2452, (_e2452 > 0f));
let _e2457 = select(_e2453, _e2455, (_e2455 < _e2453));
let _e2458 = f32(_e2435);
let _e2460 = (_e2345.member_2 - _e2338.member_2);
let _e2463 = (((((_e1932.member.z + (_e1932.member_1.z * _e2414)) - _e2338.member_2) / _e2460) * _e2458) - 0.5f);
let _e2464 = (_e2458 - 1f);
let _e2466 = select(0f, _e2463, (_e2463 > 0f));
let _e2468 = select(_e2464, _e2466, (_e2466 < _e2464));
let _e2470 = select(0f, _e2446, (_e2446 > 0f));
let _e2472 = select(1e6f, _e2470, (_e2470 < 1e6f));
let _e2479 = select(0i, select(select(i32(_e2472), i32(-2147483648), (_e2472 < -2147483600f)), 2147483647i, (_e2472 > 2147483500f)), (_e2472 == _e2472));
let _e2483 = (_e2479 - select(0i, 1i, (_e2472 < f32(_e2479))));
let _e2485 = select(0f, _e2457, (_e2457 > 0f));
let _e2487 = select(1e6f, _e2485, (_e2485 < 1e6f));
let _e2494 = select(0i, select(select(i32(_e2487), i32(-2147483648), (_e2487 < -2147483600f)), 2147483647i, (_e2487 > 2147483500f)), (_e2487 == _e2487));
let _e2498 = (_e2494 - select(0i, 1i, (_e2487 < f32(_e2494))));
let _e2500 = select(0f, _e2468, (_e2468 > 0f));
let _e2502 = select(1e6f, _e2500, (_e2500 < 1e6f));
let _e2509 = select(0i, select(select(i32(_e2502), i32(-2147483648), (_e2502 < -2147483600f)), 2147483647i, (_e2502 > 2147483500f)), (_e2502 == _e2502));
let _e2513 = (_e2509 - select(0i, 1i, (_e2502 < f32(_e2509))));
let _e2517 = (_e2457 - f32(_e2498));
let _e2519 = (_e2468 - f32(_e2513));
local_10 = (_e2446 - f32(_e2483));
let _e2520 = (_e2483 + 1i);
let _e2522 = select(_e2520, 0i, (_e2520 < 0i));
if (_e2522 >= _e2425) {
phi_5010_ = (_e2425 - 1i);
} else {
phi_5010_ = _e2522;
}
let _e2526 = phi_5010_;
local_11 = (_e2526 - _e2483);
let _e2528 = (_e2498 + 1i);
let _e2530 = select(_e2528, 0i, (_e2528 < 0i));
if (_e2530 >= _e2430) {
phi_5023_ = (_e2430 - 1i);
} else {
phi_5023_ = _e2530;
}
let _e2534 = phi_5023_;
let _e2536 = ((_e2534 - _e2498) * _e2425);
let _e2537 = (_e2513 + 1i);
let _e2539 = select(_e2537, 0i, (_e2537 < 0i));
if (_e2539 >= _e2435) {
phi_5037_ = (_e2435 - 1i);
} else {
phi_5037_ = _e2539;
}
let _e2543 = phi_5037_;
let _e2550 = global_5.member.member_13.member_10;
let _e2551 = bitcast<i32>(_e2550);
let _e2556 = ((_e2551 + (((_e2513 * _e2430) + _e2498) * _e2425)) + _e2483);
let _e2558 = select(_e2009, _e2556, (_e2556 < _e2009));
let _e2563 = global_3.member[bitcast<u32>(select(0i, _e2558, (_e2558 > 0i)))];
let _e2564 = local_10;
let _e2567 = local_11;
let _e2568 = (_e2556 + _e2567);
let _e2570 = select(_e2009, _e2568, (_e2568 < _e2009));
let _e2575 = global_3.member[bitcast<u32>(select(0i, _e2570, (_e2570 > 0i)))];
let _e2576 = local_10;
let _e2579 = (1f - _e2517);
let _e2581 = (_e2556 + _e2536);
let _e2583 = select(_e2009, _e2581, (_e2581 < _e2009));
let _e2588 = global_3.member[bitcast<u32>(select(0i, _e2583, (_e2583 > 0i)))];
let _e2589 = local_10;
let _e2592 = local_11;
let _e2593 = (_e2581 + _e2592);
let _e2595 = select(_e2009, _e2593, (_e2593 < _e2009));
let _e2600 = global_3.member[bitcast<u32>(select(0i, _e2595, (_e2595 > 0i)))];
let _e2601 = local_10;
let _e2606 = (_e2556 + (((_e2543 - _e2513) * _e2425) * _e2430));
let _e2608 = select(_e2009, _e2606, (_e2606 < _e2009));
let _e2613 = global_3.member[bitcast<u32>(select(0i, _e2608, (_e2608 > 0i)))];
let _e2614 = local_10;
let _e2617 = local_11;
let _e2618 = (_e2606 + _e2617);
let _e2620 = select(_e2009, _e2618, (_e2618 < _e2009));
let _e2625 = global_3.member[bitcast<u32>(select(0i, _e2620, (_e2620 > 0i)))];
let _e2626 = local_10;
let _e2630 = (_e2606 + _e2536);
let _e2632 = select(_e2009, _e2630, (_e2630 < _e2009));
let _e2637 = global_3.member[bitcast<u32>(select(0i, _e2632, (_e2632 > 0i)))];
let _e2638 = local_10;
let _e2641 = local_11;
let _e2642 = (_e2630 + _e2641);
let _e2644 = select(_e2009, _e2642, (_e2642 < _e2009));
let _e2649 = global_3.member[bitcast<u32>(select(0i, _e2644, (_e2644 > 0i)))];
let _e2650 = local_10;
let _e2659 = (_e2411 + _e2413);
let _e2669 = (((((_e1932.member.x + (_e1932.member_1.x * _e2659)) - _e2338.member) / _e2438) * _e2436) - 0.5f);
let _e2671 = select(0f, _e2669, (_e2669 > 0f));
let _e2673 = select(_e2442, _e2671, (_e2671 < _e2442));
let _e2677 = (((((_e1932.member.y + (_e1932.member_1.y * _e2659)) - _e2338.member_1) / _e2449) * _e2447) - 0.5f);
let _e2679 = select(0f, _e2677, (_e2677 > 0f));
let _e2681 = select(_e2453, _e2679, (_e2679 < _e2453));
let _e2685 = (((((_e1932.member.z + (_e1932.member_1.z * _e2659)) - _e2338.member_2) / _e2460) * _e2458) - 0.5f);
let _e2687 = select(0f, _e2685, (_e2685 > 0f));
let _e2689 = select(_e2464, _e2687, (_e2687 < _e2464));
let _e2691 = select(0f, _e2673, (_e2673 > 0f));
let _e2693 = select(1e6f, _e2691, (_e2691 < 1e6f));
let _e2700 = select(0i, select(select(i32(_e2693), i32(-2147483648), (_e2693 < -2147483600f)), 2147483647i, (_e2693 > 2147483500f)), (_e2693 == _e2693));
let _e2704 = (_e2700 - select(0i, 1i, (_e2693 < f32(_e2700))));
let _e2706 = select(0f, _e2681, (_e2681 > 0f));
let _e2708 = select(1e6f, _e2706, (_e2706 < 1e6f));
let _e2715 = select(0i, select(select(i32(_e2708), i32(-2147483648), (_e2708 < -2147483600f)), 2147483647i, (_e2708 > 2147483500f)), (_e2708 == _e2708));
let _e2719 = (_e2715 - select(0i, 1i, (_e2708 < f32(_e2715))));
let _e2721 = select(0f, _e2689, (_e2689 > 0f));
let _e2723 = select(1e6f, _e2721, (_e2721 < 1e6f));
let _e2730 = select(0i, select(select(i32(_e2723), i32(-2147483648), (_e2723 < -2147483600f)), 2147483647i, (_e2723 > 2147483500f)), (_e2723 == _e2723));
let _e2734 = (_e2730 - select(0i, 1i, (_e2723 < f32(_e2730))));
let _e2738 = (_e2681 - f32(_e2719));
let _e2740 = (_e2689 - f32(_e2734));
local_8 = (_e2673 - f32(_e2704));
let _e2741 = (_e2704 + 1i);
let _e2743 = select(_e2741, 0i, (_e2741 < 0i));
if (_e2743 >= _e2425) {
phi_5359_ = (_e2425 - 1i);
} else {
phi_5359_ = _e2743;
}
let _e2747 = phi_5359_;
local_9 = (_e2747 - _e2704);
let _e2749 = (_e2719 + 1i);
let _e2751 = select(_e2749, 0i, (_e2749 < 0i));
if (_e2751 >= _e2430) {
phi_5372_ = (_e2430 - 1i);
} else {
phi_5372_ = _e2751;
}
let _e2755 = phi_5372_;
let _e2757 = ((_e2755 - _e2719) * _e2425);
let _e2758 = (_e2734 + 1i);
let _e2760 = select(_e2758, 0i, (_e2758 < 0i));
if (_e2760 >= _e2435) {
phi_5386_ = (_e2435 - 1i);
} else {
phi_5386_ = _e2760;
}
let _e2764 = phi_5386_;
let _e2772 = ((_e2551 + (((_e2734 * _e2430) + _e2719) * _e2425)) + _e2704);
let _e2774 = select(_e2009, _e2772, (_e2772 < _e2009));
let _e2779 = global_3.member[bitcast<u32>(select(0i, _e2774, (_e2774 > 0i)))];
let _e2780 = local_8;
let _e2783 = local_9;
let _e2784 = (_e2772 + _e2783);
let _e2786 = select(_e2009, _e2784, (_e2784 < _e2009));
let _e2791 = global_3.member[bitcast<u32>(select(0i, _e2786, (_e2786 > 0i)))];
let _e2792 = local_8;
let _e2795 = (1f - _e2738);
let _e2797 = (_e2772 + _e2757);
let _e2799 = select(_e2009, _e2797, (_e2797 < _e2009));
let _e2804 = global_3.member[bitcast<u32>(select(0i, _e2799, (_e2799 > 0i)))];
let _e2805 = local_8;
let _e2808 = local_9;
let _e2809 = (_e2797 + _e2808);
let _e2811 = select(_e2009, _e2809, (_e2809 < _e2009));
let _e2816 = global_3.member[bitcast<u32>(select(0i, _e2811, (_e2811 > 0i)))];
let _e2817 = local_8;
let _e2822 = (_e2772 + (((_e2764 - _e2734) * _e2425) * _e2430));
let _e2824 = select(_e2009, _e2822, (_e2822 < _e2009));
let _e2829 = global_3.member[bitcast<u32>(select(0i, _e2824, (_e2824 > 0i)))];
let _e2830 = local_8;
let _e2833 = local_9;
let _e2834 = (_e2822 + _e2833);
let _e2836 = select(_e2009, _e2834, (_e2834 < _e2009));
let _e2841 = global_3.member[bitcast<u32>(select(0i, _e2836, (_e2836 > 0i)))];
let _e2842 = local_8;
let _e2846 = (_e2822 + _e2757);
let _e2848 = select(_e2009, _e2846, (_e2846 < _e2009));
let _e2853 = global_3.member[bitcast<u32>(select(0i, _e2848, (_e2848 > 0i)))];
let _e2854 = local_8;
let _e2857 = local_9;
let _e2858 = (_e2846 + _e2857);
let _e2860 = select(_e2009, _e2858, (_e2858 < _e2009));
let _e2865 = global_3.member[bitcast<u32>(select(0i, _e2860, (_e2860 > 0i)))];
let _e2866 = local_8;
phi_4867_ = (_e2400 + 1u);
phi_4870_ = (_e2402 + ((0.5f * (((((((_e2563 * (1f - _e2564)) + (_e2575 * _e2576)) * _e2579) + (((_e2588 * (1f - _e2589)) + (_e2600 * _e2601)) * _e2517)) * (1f - _e2519)) + (((((_e2613 * (1f - _e2614)) + (_e2625 * _e2626)) * _e2579) + (((_e2637 * (1f - _e2638)) + (_e2649 * _e2650)) * _e2517)) * _e2519)) + ((((((_e2779 * (1f - _e2780)) + (_e2791 * _e2792)) * _e2795) + (((_e2804 * (1f - _e2805)) + (_e2816 * _e2817)) * _e2738)) * (1f - _e2740)) + (((((_e2829 * (1f - _e2830)) + (_e2841 * _e2842)) * _e2795) + (((_e2853 * (1f - _e2854)) + (_e2865 * _e2866)) * _e2738)) * _e2740)))) * _e2412));
} else {
phi_4867_ = u32();
phi_4870_ = f32();
}
let _e2881 = phi_4867_;
let _e2883 = phi_4870_;
continue;
continuing {
phi_4866_ = _e2881;
phi_4869_ = _e2883;
break if !(_e2405);
}
}
let _e10436 = local_69;
phi_5591_ = _e10436;
}
let _e2886 = phi_5591_;
let _e2890 = global_5.member.member_13.member;
let _e2895 = -((_e2890.member * _e2886));
let _e2897 = select(-87f, _e2895, (_e2895 > -87f));
let _e2899 = select(88f, _e2897, (_e2897 < 88f));
let _e2901 = ((_e2899 * 1.442695f) + 0.5f);
let _e2903 = select(-127f, _e2901, (_e2901 > -127f));
let _e2905 = select(128f, _e2903, (_e2903 < 128f));
let _e2912 = select(0i, select(select(i32(_e2905), i32(-2147483648), (_e2905 < -2147483600f)), 2147483647i, (_e2905 > 2147483500f)), (_e2905 == _e2905));
let _e2916 = (_e2912 - select(0i, 1i, (_e2905 < f32(_e2912))));
let _e2917 = f32(_e2916);
let _e2921 = ((_e2899 - (_e2917 * 0.6933594f)) - (_e2917 * -2.1219444e-4f));
let _e2943 = -((_e2890.member_1 * _e2886));
let _e2945 = select(-87f, _e2943, (_e2943 > -87f));
let _e2947 = select(88f, _e2945, (_e2945 < 88f));
let _e2949 = ((_e2947 * 1.442695f) + 0.5f);
let _e2951 = select(-127f, _e2949, (_e2949 > -127f));
let _e2953 = select(128f, _e2951, (_e2951 < 128f));
let _e2960 = select(0i, select(select(i32(_e2953), i32(-2147483648), (_e2953 < -2147483600f)), 2147483647i, (_e2953 > 2147483500f)), (_e2953 == _e2953));
let _e2964 = (_e2960 - select(0i, 1i, (_e2953 < f32(_e2960))));
let _e2965 = f32(_e2964);
let _e2969 = ((_e2947 - (_e2965 * 0.6933594f)) - (_e2965 * -2.1219444e-4f));
let _e2991 = -((_e2890.member_2 * _e2886));
let _e2993 = select(-87f, _e2991, (_e2991 > -87f));
let _e2995 = select(88f, _e2993, (_e2993 < 88f));
let _e2997 = ((_e2995 * 1.442695f) + 0.5f);
let _e2999 = select(-127f, _e2997, (_e2997 > -127f));
let _e3001 = select(128f, _e2999, (_e2999 < 128f));
let _e3008 = select(0i, select(select(i32(_e3001), i32(-2147483648), (_e3001 < -2147483600f)), 2147483647i, (_e3001 > 2147483500f)), (_e3001 == _e3001));
let _e3012 = (_e3008 - select(0i, 1i, (_e3001 < f32(_e3008))));
let _e3013 = f32(_e3012);
let _e3017 = ((_e2995 - (_e3013 * 0.6933594f)) - (_e3013 * -2.1219444e-4f));
let _e3044 = (1f / 3f);
let _e3048 = (_e1932.member_6.x * ((1f + (_e2921 * (1f + (_e2921 * (0.5f + (_e2921 * (0.16666667f + (_e2921 * (0.041666668f + (_e2921 * (0.008333334f + (_e2921 * (0.001388889f + (_e2921 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2916 + 127i)) << bitcast<u32>(23i)))));
let _e3051 = (_e1932.member_6.y * ((1f + (_e2969 * (1f + (_e2969 * (0.5f + (_e2969 * (0.16666667f + (_e2969 * (0.041666668f + (_e2969 * (0.008333334f + (_e2969 * (0.001388889f + (_e2969 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2964 + 127i)) << bitcast<u32>(23i)))));
let _e3054 = (_e1932.member_6.z * ((1f + (_e3017 * (1f + (_e3017 * (0.5f + (_e3017 * (0.16666667f + (_e3017 * (0.041666668f + (_e3017 * (0.008333334f + (_e3017 * (0.001388889f + (_e3017 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3012 + 127i)) << bitcast<u32>(23i)))));
let _e3083 = type_27(_e1932.member, _e1932.member_1, _e1932.member_2, _e1932.member_3, _e1932.member_4, _e1932.member_5, vec3<f32>(_e3048, _e3051, _e3054), _e1932.member_7, _e1932.member_8, _e1932.member_9, _e1932.member_10, _e1932.member_11, _e1932.member_12, _e1932.member_13, _e1932.member_14, _e1932.member_15, _e1932.member_16, _e1932.member_17, _e1932.member_18, _e1932.member_19, _e1932.member_20, _e1932.member_21, _e1932.member_22, _e1932.member_23, _e1932.member_24, _e1932.member_25, _e1932.member_26, _e1932.member_27);
if _e1976 {
phi_5824_ = ((((_e1932.member_6.x + _e1932.member_6.y) + _e1932.member_6.z) * _e3044) - (((_e3048 + _e3051) + _e3054) * _e3044));
} else {
phi_5824_ = 0f;
}
let _e3089 = phi_5824_;
phi_6114_ = type_27(_e3083.member, _e3083.member_1, _e3083.member_2, _e3083.member_3, _e3083.member_4, _e3083.member_5, _e3083.member_6, _e3083.member_7, _e3083.member_8, _e3083.member_9, _e3083.member_10, _e3083.member_11, _e3083.member_12, _e3083.member_13, _e3083.member_14, _e3083.member_15, _e3083.member_16, _e3083.member_17, _e3083.member_18, _e3083.member_19, _e3083.member_20, _e3083.member_21, _e3083.member_22, _e3083.member_23, _e3083.member_24, _e3083.member_25, (_e1932.member_26 + _e3089), _e3083.member_27);
} else {
let _e2049 = select(1e6f, _e1986, (_e1986 < 1e6f));
let _e2051 = local_17;
let _e2052 = (_e2051 * 4i);
let _e2053 = (_e2052 + 1i);
let _e2055 = select(_e2009, _e2053, (_e2053 < _e2009));
let _e2061 = global_3.member[bitcast<u32>(select(0i, _e2055, (_e2055 > 0i)))];
let _e2063 = -((_e2061 * _e2049));
let _e2065 = select(-87f, _e2063, (_e2063 > -87f));
let _e2067 = select(88f, _e2065, (_e2065 < 88f));
let _e2069 = ((_e2067 * 1.442695f) + 0.5f);
let _e2071 = select(-127f, _e2069, (_e2069 > -127f));
let _e2073 = select(128f, _e2071, (_e2071 < 128f));
let _e2080 = select(0i, select(select(i32(_e2073), i32(-2147483648), (_e2073 < -2147483600f)), 2147483647i, (_e2073 > 2147483500f)), (_e2073 == _e2073));
let _e2084 = (_e2080 - select(0i, 1i, (_e2073 < f32(_e2080))));
let _e2085 = f32(_e2084);
let _e2089 = ((_e2067 - (_e2085 * 0.6933594f)) - (_e2085 * -2.1219444e-4f));
let _e2110 = (_e2052 + 2i);
let _e2112 = select(_e2009, _e2110, (_e2110 < _e2009));
let _e2118 = global_3.member[bitcast<u32>(select(0i, _e2112, (_e2112 > 0i)))];
let _e2120 = -((_e2118 * _e2049));
let _e2122 = select(-87f, _e2120, (_e2120 > -87f));
let _e2124 = select(88f, _e2122, (_e2122 < 88f));
let _e2126 = ((_e2124 * 1.442695f) + 0.5f);
let _e2128 = select(-127f, _e2126, (_e2126 > -127f));
let _e2130 = select(128f, _e2128, (_e2128 < 128f));
let _e2137 = select(0i, select(select(i32(_e2130), i32(-2147483648), (_e2130 < -2147483600f)), 2147483647i, (_e2130 > 2147483500f)), (_e2130 == _e2130));
let _e2141 = (_e2137 - select(0i, 1i, (_e2130 < f32(_e2137))));
let _e2142 = f32(_e2141);
let _e2146 = ((_e2124 - (_e2142 * 0.6933594f)) - (_e2142 * -2.1219444e-4f));
let _e2167 = (_e2052 + 3i);
let _e2169 = select(_e2009, _e2167, (_e2167 < _e2009));
let _e2175 = global_3.member[bitcast<u32>(select(0i, _e2169, (_e2169 > 0i)))];
let _e2177 = -((_e2175 * _e2049));
let _e2179 = select(-87f, _e2177, (_e2177 > -87f));
let _e2181 = select(88f, _e2179, (_e2179 < 88f));
let _e2183 = ((_e2181 * 1.442695f) + 0.5f);
let _e2185 = select(-127f, _e2183, (_e2183 > -127f));
let _e2187 = select(128f, _e2185, (_e2185 < 128f));
let _e2194 = select(0i, select(select(i32(_e2187), i32(-2147483648), (_e2187 < -2147483600f)), 2147483647i, (_e2187 > 2147483500f)), (_e2187 == _e2187));
let _e2198 = (_e2194 - select(0i, 1i, (_e2187 < f32(_e2194))));
let _e2199 = f32(_e2198);
let _e2203 = ((_e2181 - (_e2199 * 0.6933594f)) - (_e2199 * -2.1219444e-4f));
let _e2230 = (1f / 3f);
let _e2234 = (_e1932.member_6.x * ((1f + (_e2089 * (1f + (_e2089 * (0.5f + (_e2089 * (0.16666667f + (_e2089 * (0.041666668f + (_e2089 * (0.008333334f + (_e2089 * (0.001388889f + (_e2089 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2084 + 127i)) << bitcast<u32>(23i)))));
let _e2237 = (_e1932.member_6.y * ((1f + (_e2146 * (1f + (_e2146 * (0.5f + (_e2146 * (0.16666667f + (_e2146 * (0.041666668f + (_e2146 * (0.008333334f + (_e2146 * (0.001388889f + (_e2146 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2141 + 127i)) << bitcast<u32>(23i)))));
let _e2240 = (_e1932.member_6.z * ((1f + (_e2203 * (1f + (_e2203 * (0.5f + (_e2203 * (0.16666667f + (_e2203 * (0.041666668f + (_e2203 * (0.008333334f + (_e2203 * (0.001388889f + (_e2203 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2198 + 127i)) << bitcast<u32>(23i)))));
let _e2269 = type_27(_e1932.member, _e1932.member_1, _e1932.member_2, _e1932.member_3, _e1932.member_4, _e1932.member_5, vec3<f32>(_e2234, _e2237, _e2240), _e1932.member_7, _e1932.member_8, _e1932.member_9, _e1932.member_10, _e1932.member_11, _e1932.member_12, _e1932.member_13, _e1932.member_14, _e1932.member_15, _e1932.member_16, _e1932.member_17, _e1932.member_18, _e1932.member_19, _e1932.member_20, _e1932.member_21, _e1932.member_22, _e1932.member_23, _e1932.member_24, _e1932.member_25, _e1932.member_26, _e1932.member_27);
if _e1976 {
phi_6110_ = ((((_e1932.member_6.x + _e1932.member_6.y) + _e1932.member_6.z) * _e2230) - (((_e2234 + _e2237) + _e2240) * _e2230));
} else {
phi_6110_ = 0f;
}
let _e2275 = phi_6110_;
phi_6114_ = type_27(_e2269.member, _e2269.member_1, _e2269.member_2, _e2269.member_3, _e2269.member_4, _e2269.member_5, _e2269.member_6, _e2269.member_7, _e2269.member_8, _e2269.member_9, _e2269.member_10, _e2269.member_11, _e2269.member_12, _e2269.member_13, _e2269.member_14, _e2269.member_15, _e2269.member_16, _e2269.member_17, _e2269.member_18, _e2269.member_19, _e2269.member_20, _e2269.member_21, _e2269.member_22, _e2269.member_23, _e2269.member_24, (_e1932.member_25 + _e2275), _e2269.member_26, _e2269.member_27);
}
let _e3121 = phi_6114_;
if (!(_e1981) || (_e2021 && (_e2019 == 0f))) {
if (bitcast<i32>(countOneBits(bitcast<u32>((_e3121.member_17 & ((1i << bitcast<u32>((_e3121.member_16 & 31i))) - 1i))))) == _e3121.member_20) {
phi_6168_ = (((_e3121.member_6.x + _e3121.member_6.y) + _e3121.member_6.z) * (1f / 3f));
} else {
phi_6168_ = 0f;
}
let _e7335 = phi_6168_;
if (_e3121.member_9 == -1i) {
phi_6180_ = type_27(_e3121.member, _e3121.member_1, _e3121.member_2, _e3121.member_3, _e3121.member_4, _e3121.member_5, _e3121.member_6, _e3121.member_7, _e3121.member_8, _e3121.member_9, _e3121.member_10, _e3121.member_11, _e3121.member_12, _e3121.member_13, _e3121.member_14, _e3121.member_15, _e3121.member_16, _e3121.member_17, _e3121.member_18, _e3121.member_19, _e3121.member_20, _e3121.member_21, _e3121.member_22, (_e3121.member_23 + _e7335), _e3121.member_24, _e3121.member_25, _e3121.member_26, _e3121.member_27);
} else {
phi_6180_ = type_27(_e3121.member, _e3121.member_1, _e3121.member_2, _e3121.member_3, _e3121.member_4, _e3121.member_5, _e3121.member_6, _e3121.member_7, _e3121.member_8, _e3121.member_9, _e3121.member_10, _e3121.member_11, _e3121.member_12, _e3121.member_13, _e3121.member_14, _e3121.member_15, _e3121.member_16, _e3121.member_17, _e3121.member_18, _e3121.member_19, _e3121.member_20, _e3121.member_21, _e3121.member_22, _e3121.member_23, (_e3121.member_24 + _e7335), _e3121.member_25, _e3121.member_26, _e3121.member_27);
}
let _e7399 = phi_6180_;
let _e7401 = (_e7399.member_18 == 0i);
if (_e7401 && (_e7399.member_21 == 0i)) {
phi_8221_ = type_27(_e7399.member, _e7399.member_1, _e7399.member_2, _e7399.member_3, _e7399.member_4, _e7399.member_5, _e7399.member_6, _e7399.member_7, _e7399.member_8, _e7399.member_9, _e7399.member_10, _e7399.member_11, _e7399.member_12, _e7399.member_13, _e7399.member_14, 3f, _e7399.member_16, _e7399.member_17, _e7399.member_18, _e7399.member_19, _e7399.member_20, _e7399.member_21, _e7399.member_22, _e7399.member_23, _e7399.member_24, _e7399.member_25, _e7399.member_26, _e7399.member_27);
} else {
if _e7401 {
let _e7533 = type_27(_e7399.member, _e7399.member_1, _e7399.member_2, _e7399.member_3, _e7399.member_4, _e7399.member_5, _e7399.member_6, _e7399.member_7, _e7399.member_8, _e7399.member_9, _e7399.member_10, _e7399.member_11, _e7399.member_12, _e7399.member_13, _e7399.member_14, _e7399.member_15, _e7399.member_16, _e7399.member_17, _e7399.member_18, _e7399.member_19, (_e7399.member_20 + 1i), _e7399.member_21, _e7399.member_22, _e7399.member_23, _e7399.member_24, _e7399.member_25, _e7399.member_26, _e7399.member_27);
let _e7561 = type_27(_e7533.member, _e7533.member_1, _e7533.member_2, _e7533.member_3, _e7533.member_4, _e7533.member_5, _e7533.member_6, _e7533.member_7, _e7533.member_8, _e7533.member_9, _e7533.member_10, _e7533.member_11, _e7533.member_12, _e7533.member_13, _e7533.member_14, _e7533.member_15, _e7533.member_16, _e7533.member_17, _e7533.member_18, _e7533.member_19, _e7533.member_20, 0i, _e7533.member_22, _e7533.member_23, _e7533.member_24, _e7533.member_25, _e7533.member_26, _e7533.member_27);
let _e7589 = type_27(_e7561.member, _e7561.member_1, _e7561.member_2, _e7561.member_3, _e7561.member_4, _e7561.member_5, _e7561.member_6, _e7561.member_7, _e7561.member_8, _e7561.member_9, _e7561.member_10, _e7561.member_11, _e7561.member_12, _e7561.member_13, _e7561.member_14, _e7561.member_15, _e7561.member_16, 0i, _e7561.member_18, _e7561.member_19, _e7561.member_20, _e7561.member_21, _e7561.member_22, _e7561.member_23, _e7561.member_24, _e7561.member_25, _e7561.member_26, _e7561.member_27);
phi_6221_ = type_27(_e7589.member, _e7589.member_1, _e7589.member_2, _e7589.member_3, _e7589.member_4, _e7589.member_5, _e7589.member_6, _e7589.member_7, _e7589.member_8, _e7589.member_9, _e7589.member_10, _e7589.member_11, _e7589.member_12, _e7589.member_13, _e7589.member_14, _e7589.member_15, _e7589.member_16, _e7589.member_17, _e7589.member_18, 0i, _e7589.member_20, _e7589.member_21, _e7589.member_22, _e7589.member_23, _e7589.member_24, _e7589.member_25, _e7589.member_26, _e7589.member_27);
} else {
let _e7409 = bitcast<i32>((bitcast<u32>(f32(_e7399.member_18)) >> bitcast<u32>(23i)));
let _e7413 = (1i << bitcast<u32>(((_e7409 - 127i) & 31i)));
let _e7414 = (_e7413 - 1i);
let _e7445 = type_27(_e7399.member, _e7399.member_1, _e7399.member_2, _e7399.member_3, _e7399.member_4, _e7399.member_5, _e7399.member_6, _e7399.member_7, _e7399.member_8, _e7399.member_9, _e7399.member_10, _e7399.member_11, _e7399.member_12, _e7399.member_13, _e7399.member_14, _e7399.member_15, _e7399.member_16, ((_e7399.member_17 & _e7414) | _e7413), _e7399.member_18, _e7399.member_19, _e7399.member_20, _e7399.member_21, _e7399.member_22, _e7399.member_23, _e7399.member_24, _e7399.member_25, _e7399.member_26, _e7399.member_27);
let _e7474 = type_27(_e7445.member, _e7445.member_1, _e7445.member_2, _e7445.member_3, _e7445.member_4, _e7445.member_5, _e7445.member_6, _e7445.member_7, _e7445.member_8, _e7445.member_9, _e7445.member_10, _e7445.member_11, _e7445.member_12, _e7445.member_13, _e7445.member_14, _e7445.member_15, _e7445.member_16, _e7445.member_17, (_e7399.member_18 & _e7414), _e7445.member_19, _e7445.member_20, _e7445.member_21, _e7445.member_22, _e7445.member_23, _e7445.member_24, _e7445.member_25, _e7445.member_26, _e7445.member_27);
phi_6221_ = type_27(_e7474.member, _e7474.member_1, _e7474.member_2, _e7474.member_3, _e7474.member_4, _e7474.member_5, _e7474.member_6, _e7474.member_7, _e7474.member_8, _e7474.member_9, _e7474.member_10, _e7474.member_11, _e7474.member_12, _e7474.member_13, _e7474.member_14, _e7474.member_15, _e7474.member_16, _e7474.member_17, _e7474.member_18, (_e7409 + -126i), _e7474.member_20, _e7474.member_21, _e7474.member_22, _e7474.member_23, _e7474.member_24, _e7474.member_25, _e7474.member_26, _e7474.member_27);
}
let _e7619 = phi_6221_;
let _e7625 = global_5.member.member_1.member;
let _e7627 = f32(bitcast<i32>(_e7625));
let _e7631 = global_5.member.member_1.member_1;
let _e7633 = f32(bitcast<i32>(_e7631));
let _e7643 = global_5.member.member_2.member;
let _e7644 = (((((f32(bitcast<i32>(_e140.x)) + 0.5f) / _e7627) * 2f) - 1f) * _e7643);
let _e7652 = global_5.member.member_2.member_1;
let _e7653 = ((1f - (((f32(bitcast<i32>(_e140.y)) + 0.5f) / _e7633) * 2f)) * _e7652);
let _e7656 = global_5.member.member_3;
let _e7665 = global_5.member.member_4;
let _e7672 = ((_e7656.member * _e7644) + (_e7665.member * _e7653));
let _e7673 = ((_e7656.member_1 * _e7644) + (_e7665.member_1 * _e7653));
let _e7674 = ((_e7656.member_2 * _e7644) + (_e7665.member_2 * _e7653));
let _e7678 = global_5.member.member_2.member_3;
let _e7679 = (_e7678 != 0u);
let _e7682 = global_5.member.member_5;
let _e7689 = select((_e7682.member + _e7672), _e7682.member, _e7679);
let _e7690 = select((_e7682.member_1 + _e7673), _e7682.member_1, _e7679);
let _e7691 = select((_e7682.member_2 + _e7674), _e7682.member_2, _e7679);
let _e7694 = global_5.member.member_6;
let _e7701 = select(_e7694.member, (_e7694.member + _e7672), _e7679);
let _e7702 = select(_e7694.member_1, (_e7694.member_1 + _e7673), _e7679);
let _e7703 = select(_e7694.member_2, (_e7694.member_2 + _e7674), _e7679);
let _e7709 = (((_e7689 * _e7689) + (_e7690 * _e7690)) + (_e7691 * _e7691));
let _e7713 = (1f / sqrt(select(0f, _e7709, (_e7709 > 0f))));
let _e7714 = (_e7689 * _e7713);
let _e7715 = (_e7690 * _e7713);
let _e7716 = (_e7691 * _e7713);
let _e7719 = ((2f * _e7643) / _e7627);
let _e7720 = (_e7656.member * _e7719);
let _e7721 = (_e7656.member_1 * _e7719);
let _e7722 = (_e7656.member_2 * _e7719);
let _e7724 = ((-2f * _e7652) / _e7633);
let _e7725 = (_e7665.member * _e7724);
let _e7726 = (_e7665.member_1 * _e7724);
let _e7727 = (_e7665.member_2 * _e7724);
let _e7740 = (((_e7720 * _e7714) + (_e7721 * _e7715)) + (_e7722 * _e7716));
let _e7750 = select(((_e7720 - (_e7714 * _e7740)) * _e7713), 0f, _e7679);
let _e7751 = select(((_e7721 - (_e7715 * _e7740)) * _e7713), 0f, _e7679);
let _e7752 = select(((_e7722 - (_e7716 * _e7740)) * _e7713), 0f, _e7679);
let _e7758 = (((_e7725 * _e7714) + (_e7726 * _e7715)) + (_e7727 * _e7716));
let _e7768 = select(((_e7725 - (_e7714 * _e7758)) * _e7713), 0f, _e7679);
let _e7769 = select(((_e7726 - (_e7715 * _e7758)) * _e7713), 0f, _e7679);
let _e7770 = select(((_e7727 - (_e7716 * _e7758)) * _e7713), 0f, _e7679);
let _e7779 = (1f / select(_e7714, select(1e-12f, -1e-12f, (_e7714 < 0f)), (bitcast<f32>((bitcast<u32>(_e7714) & 2147483647u)) < 1e-12f)));
let _e7787 = (1f / select(_e7715, select(1e-12f, -1e-12f, (_e7715 < 0f)), (bitcast<f32>((bitcast<u32>(_e7715) & 2147483647u)) < 1e-12f)));
let _e7795 = (1f / select(_e7716, select(1e-12f, -1e-12f, (_e7716 < 0f)), (bitcast<f32>((bitcast<u32>(_e7716) & 2147483647u)) < 1e-12f)));
let _e7798 = global_5.member.member_8;
let _e7804 = global_5.member.member_9;
let _e7809 = ((_e7798.member - _e7701) * _e7779);
let _e7811 = ((_e7804.member - _e7701) * _e7779);
let _e7813 = ((_e7798.member_1 - _e7702) * _e7787);
let _e7815 = ((_e7804.member_1 - _e7702) * _e7787);
let _e7817 = ((_e7798.member_2 - _e7703) * _e7795);
let _e7819 = ((_e7804.member_2 - _e7703) * _e7795);
let _e7821 = select(_e7811, _e7809, (_e7809 < _e7811));
let _e7823 = select(_e7815, _e7813, (_e7813 < _e7815));
let _e7825 = select(_e7823, _e7821, (_e7821 > _e7823));
let _e7827 = select(_e7819, _e7817, (_e7817 < _e7819));
let _e7829 = select(_e7827, _e7825, (_e7825 > _e7827));
let _e7831 = select(_e7811, _e7809, (_e7809 > _e7811));
let _e7833 = select(_e7815, _e7813, (_e7813 > _e7815));
let _e7835 = select(_e7833, _e7831, (_e7831 < _e7833));
let _e7837 = select(_e7819, _e7817, (_e7817 > _e7819));
let _e7841 = select(0f, _e7829, (_e7829 > 0f));
let _e7846 = global_5.member.member_14.member.member;
let _e7857 = ((((_e7846.member.member * _e7701) + (_e7846.member.member_1 * _e7702)) + (_e7846.member.member_2 * _e7703)) + _e7846.member_1);
let _e7863 = -((((_e7846.member.member * _e7714) + (_e7846.member.member_1 * _e7715)) + (_e7846.member.member_2 * _e7716)));
let _e7865 = (_e7863 > 1e-9f);
let _e7867 = select(1e-9f, _e7863, _e7865);
let _e7869 = ((_e7857 / _e7867) - 0.015625f);
let _e7872 = select(1e30f, select(0f, _e7869, (_e7869 > 0f)), ((_e7857 > 0f) && _e7865));
let _e7877 = global_5.member.member_14.member_1.member;
let _e7888 = ((((_e7877.member.member * _e7701) + (_e7877.member.member_1 * _e7702)) + (_e7877.member.member_2 * _e7703)) + _e7877.member_1);
let _e7894 = -((((_e7877.member.member * _e7714) + (_e7877.member.member_1 * _e7715)) + (_e7877.member.member_2 * _e7716)));
let _e7896 = (_e7894 > 1e-9f);
let _e7898 = select(1e-9f, _e7894, _e7896);
let _e7900 = ((_e7888 / _e7898) - 0.015625f);
let _e7903 = select(1e30f, select(0f, _e7900, (_e7900 > 0f)), ((_e7888 > 0f) && _e7896));
let _e7909 = ((select(_e7837, _e7835, (_e7835 < _e7837)) <= _e7841) || (true && (select(_e7872, _e7903, (_e7903 < _e7872)) <= _e7841)));
let _e7910 = select(_e7841, 0f, _e7909);
let _e7911 = (_e7714 * _e7910);
let _e7912 = (_e7715 * _e7910);
let _e7913 = (_e7716 * _e7910);
let _e7914 = (_e7701 + _e7911);
let _e7915 = (_e7702 + _e7912);
let _e7916 = (_e7703 + _e7913);
let _e7946 = type_27((vec3<f32>(_e7701, _e7702, _e7703) + vec3<f32>(_e7911, _e7912, _e7913)), _e7619.member_1, _e7619.member_2, _e7619.member_3, _e7619.member_4, _e7619.member_5, _e7619.member_6, _e7619.member_7, _e7619.member_8, _e7619.member_9, _e7619.member_10, _e7619.member_11, _e7619.member_12, _e7619.member_13, _e7619.member_14, _e7619.member_15, _e7619.member_16, _e7619.member_17, _e7619.member_18, _e7619.member_19, _e7619.member_20, _e7619.member_21, _e7619.member_22, _e7619.member_23, _e7619.member_24, _e7619.member_25, _e7619.member_26, _e7619.member_27);
let _e7974 = type_27(_e7946.member, vec3<f32>(_e7714, _e7715, _e7716), _e7946.member_2, _e7946.member_3, _e7946.member_4, _e7946.member_5, _e7946.member_6, _e7946.member_7, _e7946.member_8, _e7946.member_9, _e7946.member_10, _e7946.member_11, _e7946.member_12, _e7946.member_13, _e7946.member_14, _e7946.member_15, _e7946.member_16, _e7946.member_17, _e7946.member_18, _e7946.member_19, _e7946.member_20, _e7946.member_21, _e7946.member_22, _e7946.member_23, _e7946.member_24, _e7946.member_25, _e7946.member_26, _e7946.member_27);
let _e8012 = type_27(_e7974.member, _e7974.member_1, (vec3<f32>(select(0f, _e7720, _e7679), select(0f, _e7721, _e7679), select(0f, _e7722, _e7679)) + vec3<f32>((_e7750 * _e7910), (_e7751 * _e7910), (_e7752 * _e7910))), _e7974.member_3, _e7974.member_4, _e7974.member_5, _e7974.member_6, _e7974.member_7, _e7974.member_8, _e7974.member_9, _e7974.member_10, _e7974.member_11, _e7974.member_12, _e7974.member_13, _e7974.member_14, _e7974.member_15, _e7974.member_16, _e7974.member_17, _e7974.member_18, _e7974.member_19, _e7974.member_20, _e7974.member_21, _e7974.member_22, _e7974.member_23, _e7974.member_24, _e7974.member_25, _e7974.member_26, _e7974.member_27);
let _e8040 = type_27(_e8012.member, _e8012.member_1, _e8012.member_2, (vec3<f32>(select(0f, _e7725, _e7679), select(0f, _e7726, _e7679), select(0f, _e7727, _e7679)) + vec3<f32>((_e7768 * _e7910), (_e7769 * _e7910), (_e7770 * _e7910))), _e8012.member_4, _e8012.member_5, _e8012.member_6, _e8012.member_7, _e8012.member_8, _e8012.member_9, _e8012.member_10, _e8012.member_11, _e8012.member_12, _e8012.member_13, _e8012.member_14, _e8012.member_15, _e8012.member_16, _e8012.member_17, _e8012.member_18, _e8012.member_19, _e8012.member_20, _e8012.member_21, _e8012.member_22, _e8012.member_23, _e8012.member_24, _e8012.member_25, _e8012.member_26, _e8012.member_27);
let _e8068 = type_27(_e8040.member, _e8040.member_1, _e8040.member_2, _e8040.member_3, vec3<f32>(_e7750, _e7751, _e7752), _e8040.member_5, _e8040.member_6, _e8040.member_7, _e8040.member_8, _e8040.member_9, _e8040.member_10, _e8040.member_11, _e8040.member_12, _e8040.member_13, _e8040.member_14, _e8040.member_15, _e8040.member_16, _e8040.member_17, _e8040.member_18, _e8040.member_19, _e8040.member_20, _e8040.member_21, _e8040.member_22, _e8040.member_23, _e8040.member_24, _e8040.member_25, _e8040.member_26, _e8040.member_27);
let _e8096 = type_27(_e8068.member, _e8068.member_1, _e8068.member_2, _e8068.member_3, _e8068.member_4, vec3<f32>(_e7768, _e7769, _e7770), _e8068.member_6, _e8068.member_7, _e8068.member_8, _e8068.member_9, _e8068.member_10, _e8068.member_11, _e8068.member_12, _e8068.member_13, _e8068.member_14, _e8068.member_15, _e8068.member_16, _e8068.member_17, _e8068.member_18, _e8068.member_19, _e8068.member_20, _e8068.member_21, _e8068.member_22, _e8068.member_23, _e8068.member_24, _e8068.member_25, _e8068.member_26, _e8068.member_27);
let _e8124 = type_27(_e8096.member, _e8096.member_1, _e8096.member_2, _e8096.member_3, _e8096.member_4, _e8096.member_5, _e8096.member_6, 0i, _e8096.member_8, _e8096.member_9, _e8096.member_10, _e8096.member_11, _e8096.member_12, _e8096.member_13, _e8096.member_14, _e8096.member_15, _e8096.member_16, _e8096.member_17, _e8096.member_18, _e8096.member_19, _e8096.member_20, _e8096.member_21, _e8096.member_22, _e8096.member_23, _e8096.member_24, _e8096.member_25, _e8096.member_26, _e8096.member_27);
let _e8152 = type_27(_e8124.member, _e8124.member_1, _e8124.member_2, _e8124.member_3, _e8124.member_4, _e8124.member_5, _e8124.member_6, _e8124.member_7, _e8124.member_8, _e8124.member_9, _e8124.member_10, _e8124.member_11, _e8124.member_12, _e8124.member_13, _e8124.member_14, _e8124.member_15, 0i, _e8124.member_17, _e8124.member_18, _e8124.member_19, _e8124.member_20, _e8124.member_21, _e8124.member_22, _e8124.member_23, _e8124.member_24, _e8124.member_25, _e8124.member_26, _e8124.member_27);
let _e8180 = type_27(_e8152.member, _e8152.member_1, _e8152.member_2, _e8152.member_3, _e8152.member_4, _e8152.member_5, _e8152.member_6, _e8152.member_7, _e8152.member_8, _e8152.member_9, _e8152.member_10, _e8152.member_11, _e8152.member_12, _e8152.member_13, _e8152.member_14, 1f, _e8152.member_16, _e8152.member_17, _e8152.member_18, _e8152.member_19, _e8152.member_20, _e8152.member_21, _e8152.member_22, _e8152.member_23, _e8152.member_24, _e8152.member_25, _e8152.member_26, _e8152.member_27);
let _e8208 = type_27(_e8180.member, _e8180.member_1, _e8180.member_2, _e8180.member_3, _e8180.member_4, _e8180.member_5, _e8180.member_6, _e8180.member_7, _e8180.member_8, _e8180.member_9, _e8180.member_10, _e8180.member_11, _e8180.member_12, 0f, _e8180.member_14, _e8180.member_15, _e8180.member_16, _e8180.member_17, _e8180.member_18, _e8180.member_19, _e8180.member_20, _e8180.member_21, _e8180.member_22, _e8180.member_23, _e8180.member_24, _e8180.member_25, _e8180.member_26, _e8180.member_27);
let _e8236 = type_27(_e8208.member, _e8208.member_1, _e8208.member_2, _e8208.member_3, _e8208.member_4, _e8208.member_5, _e8208.member_6, _e8208.member_7, _e8208.member_8, _e8208.member_9, _e8208.member_10, 0i, _e8208.member_12, _e8208.member_13, _e8208.member_14, _e8208.member_15, _e8208.member_16, _e8208.member_17, _e8208.member_18, _e8208.member_19, _e8208.member_20, _e8208.member_21, _e8208.member_22, _e8208.member_23, _e8208.member_24, _e8208.member_25, _e8208.member_26, _e8208.member_27);
let _e8264 = type_27(_e8236.member, _e8236.member_1, _e8236.member_2, _e8236.member_3, _e8236.member_4, _e8236.member_5, _e8236.member_6, _e8236.member_7, _e8236.member_8, _e8236.member_9, _e8236.member_10, _e8236.member_11, 0i, _e8236.member_13, _e8236.member_14, _e8236.member_15, _e8236.member_16, _e8236.member_17, _e8236.member_18, _e8236.member_19, _e8236.member_20, _e8236.member_21, _e8236.member_22, _e8236.member_23, _e8236.member_24, _e8236.member_25, _e8236.member_26, _e8236.member_27);
let _e8270 = ((((_e7846.member.member * _e7914) + (_e7846.member.member_1 * _e7915)) + (_e7846.member.member_2 * _e7916)) + _e7846.member_1);
let _e8274 = ((_e8270 / _e7867) - 0.015625f);
let _e8277 = select(1e30f, select(0f, _e8274, (_e8274 > 0f)), ((_e8270 > 0f) && _e7865));
let _e8283 = ((((_e7877.member.member * _e7914) + (_e7877.member.member_1 * _e7915)) + (_e7877.member.member_2 * _e7916)) + _e7877.member_1);
let _e8287 = ((_e8283 / _e7898) - 0.015625f);
let _e8290 = select(1e30f, select(0f, _e8287, (_e8287 > 0f)), ((_e8283 > 0f) && _e7896));
let _e8294 = (_e8290 < _e8277);
let _e8325 = type_27(_e8264.member, _e8264.member_1, _e8264.member_2, _e8264.member_3, _e8264.member_4, _e8264.member_5, _e8264.member_6, _e8264.member_7, 0i, _e8264.member_9, _e8264.member_10, _e8264.member_11, _e8264.member_12, _e8264.member_13, _e8264.member_14, _e8264.member_15, _e8264.member_16, _e8264.member_17, _e8264.member_18, _e8264.member_19, _e8264.member_20, _e8264.member_21, _e8264.member_22, _e8264.member_23, _e8264.member_24, _e8264.member_25, _e8264.member_26, _e8264.member_27);
let _e8353 = type_27(_e8325.member, _e8325.member_1, _e8325.member_2, _e8325.member_3, _e8325.member_4, _e8325.member_5, _e8325.member_6, _e8325.member_7, _e8325.member_8, select(select(-2i, -3i, _e8294), -1i, ((_e8277 >= 1e30f) && (_e8290 >= 1e30f))), _e8325.member_10, _e8325.member_11, _e8325.member_12, _e8325.member_13, _e8325.member_14, _e8325.member_15, _e8325.member_16, _e8325.member_17, _e8325.member_18, _e8325.member_19, _e8325.member_20, _e8325.member_21, _e8325.member_22, _e8325.member_23, _e8325.member_24, _e8325.member_25, _e8325.member_26, _e8325.member_27);
let _e8381 = type_27(_e8353.member, _e8353.member_1, _e8353.member_2, _e8353.member_3, _e8353.member_4, _e8353.member_5, _e8353.member_6, _e8353.member_7, _e8353.member_8, _e8353.member_9, select(_e8277, _e8290, _e8294), _e8353.member_11, _e8353.member_12, _e8353.member_13, _e8353.member_14, _e8353.member_15, _e8353.member_16, _e8353.member_17, _e8353.member_18, _e8353.member_19, _e8353.member_20, _e8353.member_21, _e8353.member_22, _e8353.member_23, _e8353.member_24, _e8353.member_25, _e8353.member_26, _e8353.member_27);
let _e8385 = global_5.member.member_13.member_4;
let _e8392 = global_5.member.member_13.member_5;
let _e8397 = ((_e8385.member - _e7701) * _e7779);
let _e8399 = ((_e8392.member - _e7701) * _e7779);
let _e8401 = ((_e8385.member_1 - _e7702) * _e7787);
let _e8403 = ((_e8392.member_1 - _e7702) * _e7787);
let _e8405 = ((_e8385.member_2 - _e7703) * _e7795);
let _e8407 = ((_e8392.member_2 - _e7703) * _e7795);
let _e8409 = select(_e8399, _e8397, (_e8397 < _e8399));
let _e8411 = select(_e8403, _e8401, (_e8401 < _e8403));
let _e8413 = select(_e8411, _e8409, (_e8409 > _e8411));
let _e8415 = select(_e8407, _e8405, (_e8405 < _e8407));
let _e8417 = select(_e8415, _e8413, (_e8413 > _e8415));
let _e8419 = select(_e8399, _e8397, (_e8397 > _e8399));
let _e8421 = select(_e8403, _e8401, (_e8401 > _e8403));
let _e8423 = select(_e8421, _e8419, (_e8419 < _e8421));
let _e8425 = select(_e8407, _e8405, (_e8405 > _e8407));
let _e8427 = select(_e8425, _e8423, (_e8423 < _e8425));
let _e8429 = select(0f, _e8417, (_e8417 > 0f));
let _e8431 = select(_e7910, _e8427, (_e8427 < _e7910));
let _e8432 = (_e8431 > _e8429);
let _e8433 = select(0f, _e8429, _e8432);
let _e8435 = (select(0f, _e8431, _e8432) - _e8433);
let _e8439 = global_5.member.member_13.member_6;
if (_e8439 == 0u) {
phi_7965_ = _e8435;
} else {
let _e8442 = (_e8435 / f32(_e8439));
phi_7240_ = 0u;
phi_7243_ = 0f;
loop {
let _e8444 = phi_7240_;
let _e8446 = phi_7243_;
local_71 = _e8446;
let _e8449 = ((_e8444 < _e8439) && (_e8435 > 0f));
if _e8449 {
let _e8452 = (_e8433 + (_e8442 * f32(_e8444)));
let _e8453 = (_e8452 + _e8442);
let _e8455 = (0.5f * (_e8452 + _e8453));
let _e8456 = (_e8453 - _e8452);
let _e8457 = (0.28867513f * _e8456);
let _e8458 = (_e8455 - _e8457);
let _e8468 = global_5.member.member_13.member_7;
let _e8469 = bitcast<i32>(_e8468);
let _e8473 = global_5.member.member_13.member_8;
let _e8474 = bitcast<i32>(_e8473);
let _e8478 = global_5.member.member_13.member_9;
let _e8479 = bitcast<i32>(_e8478);
let _e8480 = f32(_e8469);
let _e8482 = (_e8392.member - _e8385.member);
let _e8485 = (((((_e7701 + (_e7714 * _e8458)) - _e8385.member) / _e8482) * _e8480) - 0.5f);
let _e8486 = (_e8480 - 1f);
let _e8488 = select(0f, _e8485, (_e8485 > 0f));
let _e8490 = select(_e8486, _e8488, (_e8488 < _e8486));
let _e8491 = f32(_e8474);
let _e8493 = (_e8392.member_1 - _e8385.member_1);
let _e8496 = (((((_e7702 + (_e7715 * _e8458)) - _e8385.member_1) / _e8493) * _e8491) - 0.5f);
let _e8497 = (_e8491 - 1f);
let _e8499 = select(0f, _e8496, (_e8496 > 0f));
let _e8501 = select(_e8497, _e8499, (_e8499 < _e8497));
let _e8502 = f32(_e8479);
let _e8504 = (_e8392.member_2 - _e8385.member_2);
let _e8507 = (((((_e7703 + (_e7716 * _e8458)) - _e8385.member_2) / _e8504) * _e8502) - 0.5f);
let _e8508 = (_e8502 - 1f);
let _e8510 = select(0f, _e8507, (_e8507 > 0f));
let _e8512 = select(_e8508, _e8510, (_e8510 < _e8508));
let _e8514 = select(0f, _e8490, (_e8490 > 0f));
let _e8516 = select(1e6f, _e8514, (_e8514 < 1e6f));
let _e8523 = select(0i, select(select(i32(_e8516), i32(-2147483648), (_e8516 < -2147483600f)), 2147483647i, (_e8516 > 2147483500f)), (_e8516 == _e8516));
let _e8527 = (_e8523 - select(0i, 1i, (_e8516 < f32(_e8523))));
let _e8529 = select(0f, _e8501, (_e8501 > 0f));
let _e8531 = select(1e6f, _e8529, (_e8529 < 1e6f));
let _e8538 = select(0i, select(select(i32(_e8531), i32(-2147483648), (_e8531 < -2147483600f)), 2147483647i, (_e8531 > 2147483500f)), (_e8531 == _e8531));
let _e8542 = (_e8538 - select(0i, 1i, (_e8531 < f32(_e8538))));
let _e8544 = select(0f, _e8512, (_e8512 > 0f));
let _e8546 = select(1e6f, _e8544, (_e8544 < 1e6f));
let _e8553 = select(0i, select(select(i32(_e8546), i32(-2147483648), (_e8546 < -2147483600f)), 2147483647i, (_e8546 > 2147483500f)), (_e8546 == _e8546));
let _e8557 = (_e8553 - select(0i, 1i, (_e8546 < f32(_e8553))));
let _e8561 = (_e8501 - f32(_e8542));
let _e8563 = (_e8512 - f32(_e8557));
local_6 = (_e8490 - f32(_e8527));
let _e8564 = (_e8527 + 1i);
let _e8566 = select(_e8564, 0i, (_e8564 < 0i));
if (_e8566 >= _e8469) {
phi_7384_ = (_e8469 - 1i);
} else {
phi_7384_ = _e8566;
}
let _e8570 = phi_7384_;
local_7 = (_e8570 - _e8527);
let _e8572 = (_e8542 + 1i);
let _e8574 = select(_e8572, 0i, (_e8572 < 0i));
if (_e8574 >= _e8474) {
phi_7397_ = (_e8474 - 1i);
} else {
phi_7397_ = _e8574;
}
let _e8578 = phi_7397_;
let _e8580 = ((_e8578 - _e8542) * _e8469);
let _e8581 = (_e8557 + 1i);
let _e8583 = select(_e8581, 0i, (_e8581 < 0i));
if (_e8583 >= _e8479) {
phi_7411_ = (_e8479 - 1i);
} else {
phi_7411_ = _e8583;
}
let _e8587 = phi_7411_;
let _e8594 = global_5.member.member_13.member_10;
let _e8595 = bitcast<i32>(_e8594);
let _e8600 = ((_e8595 + (((_e8557 * _e8474) + _e8542) * _e8469)) + _e8527);
let _e8602 = select(_e2009, _e8600, (_e8600 < _e2009));
let _e8607 = global_3.member[bitcast<u32>(select(0i, _e8602, (_e8602 > 0i)))];
let _e8608 = local_6;
let _e8611 = local_7;
let _e8612 = (_e8600 + _e8611);
let _e8614 = select(_e2009, _e8612, (_e8612 < _e2009));
let _e8619 = global_3.member[bitcast<u32>(select(0i, _e8614, (_e8614 > 0i)))];
let _e8620 = local_6;
let _e8623 = (1f - _e8561);
let _e8625 = (_e8600 + _e8580);
let _e8627 = select(_e2009, _e8625, (_e8625 < _e2009));
let _e8632 = global_3.member[bitcast<u32>(select(0i, _e8627, (_e8627 > 0i)))];
let _e8633 = local_6;
let _e8636 = local_7;
let _e8637 = (_e8625 + _e8636);
let _e8639 = select(_e2009, _e8637, (_e8637 < _e2009));
let _e8644 = global_3.member[bitcast<u32>(select(0i, _e8639, (_e8639 > 0i)))];
let _e8645 = local_6;
let _e8650 = (_e8600 + (((_e8587 - _e8557) * _e8469) * _e8474));
let _e8652 = select(_e2009, _e8650, (_e8650 < _e2009));
let _e8657 = global_3.member[bitcast<u32>(select(0i, _e8652, (_e8652 > 0i)))];
let _e8658 = local_6;
let _e8661 = local_7;
let _e8662 = (_e8650 + _e8661);
let _e8664 = select(_e2009, _e8662, (_e8662 < _e2009));
let _e8669 = global_3.member[bitcast<u32>(select(0i, _e8664, (_e8664 > 0i)))];
let _e8670 = local_6;
let _e8674 = (_e8650 + _e8580);
let _e8676 = select(_e2009, _e8674, (_e8674 < _e2009));
let _e8681 = global_3.member[bitcast<u32>(select(0i, _e8676, (_e8676 > 0i)))];
let _e8682 = local_6;
let _e8685 = local_7;
let _e8686 = (_e8674 + _e8685);
let _e8688 = select(_e2009, _e8686, (_e8686 < _e2009));
let _e8693 = global_3.member[bitcast<u32>(select(0i, _e8688, (_e8688 > 0i)))];
let _e8694 = local_6;
let _e8703 = (_e8455 + _e8457);
let _e8713 = (((((_e7701 + (_e7714 * _e8703)) - _e8385.member) / _e8482) * _e8480) - 0.5f);
let _e8715 = select(0f, _e8713, (_e8713 > 0f));
let _e8717 = select(_e8486, _e8715, (_e8715 < _e8486));
let _e8721 = (((((_e7702 + (_e7715 * _e8703)) - _e8385.member_1) / _e8493) * _e8491) - 0.5f);
let _e8723 = select(0f, _e8721, (_e8721 > 0f));
let _e8725 = select(_e8497, _e8723, (_e8723 < _e8497));
let _e8729 = (((((_e7703 + (_e7716 * _e8703)) - _e8385.member_2) / _e8504) * _e8502) - 0.5f);
let _e8731 = select(0f, _e8729, (_e8729 > 0f));
let _e8733 = select(_e8508, _e8731, (_e8731 < _e8508));
let _e8735 = select(0f, _e8717, (_e8717 > 0f));
let _e8737 = select(1e6f, _e8735, (_e8735 < 1e6f));
let _e8744 = select(0i, select(select(i32(_e8737), i32(-2147483648), (_e8737 < -2147483600f)), 2147483647i, (_e8737 > 2147483500f)), (_e8737 == _e8737));
let _e8748 = (_e8744 - select(0i, 1i, (_e8737 < f32(_e8744))));
let _e8750 = select(0f, _e8725, (_e8725 > 0f));
let _e8752 = select(1e6f, _e8750, (_e8750 < 1e6f));
let _e8759 = select(0i, select(select(i32(_e8752), i32(-2147483648), (_e8752 < -2147483600f)), 2147483647i, (_e8752 > 2147483500f)), (_e8752 == _e8752));
let _e8763 = (_e8759 - select(0i, 1i, (_e8752 < f32(_e8759))));
let _e8765 = select(0f, _e8733, (_e8733 > 0f));
let _e8767 = select(1e6f, _e8765, (_e8765 < 1e6f));
let _e8774 = select(0i, select(select(i32(_e8767), i32(-2147483648), (_e8767 < -2147483600f)), 2147483647i, (_e8767 > 2147483500f)), (_e8767 == _e8767));
let _e8778 = (_e8774 - select(0i, 1i, (_e8767 < f32(_e8774))));
let _e8782 = (_e8725 - f32(_e8763));
let _e8784 = (_e8733 - f32(_e8778));
local_4 = (_e8717 - f32(_e8748));
let _e8785 = (_e8748 + 1i);
let _e8787 = select(_e8785, 0i, (_e8785 < 0i));
if (_e8787 >= _e8469) {
phi_7733_ = (_e8469 - 1i);
} else {
phi_7733_ = _e8787;
}
let _e8791 = phi_7733_;
local_5 = (_e8791 - _e8748);
let _e8793 = (_e8763 + 1i);
let _e8795 = select(_e8793, 0i, (_e8793 < 0i));
if (_e8795 >= _e8474) {
phi_7746_ = (_e8474 - 1i);
} else {
phi_7746_ = _e8795;
}
let _e8799 = phi_7746_;
let _e8801 = ((_e8799 - _e8763) * _e8469);
let _e8802 = (_e8778 + 1i);
let _e8804 = select(_e8802, 0i, (_e8802 < 0i));
if (_e8804 >= _e8479) {
phi_7760_ = (_e8479 - 1i);
} else {
phi_7760_ = _e8804;
}
let _e8808 = phi_7760_;
let _e8816 = ((_e8595 + (((_e8778 * _e8474) + _e8763) * _e8469)) + _e8748);
let _e8818 = select(_e2009, _e8816, (_e8816 < _e2009));
let _e8823 = global_3.member[bitcast<u32>(select(0i, _e8818, (_e8818 > 0i)))];
let _e8824 = local_4;
let _e8827 = local_5;
let _e8828 = (_e8816 + _e8827);
let _e8830 = select(_e2009, _e8828, (_e8828 < _e2009));
let _e8835 = global_3.member[bitcast<u32>(select(0i, _e8830, (_e8830 > 0i)))];
let _e8836 = local_4;
let _e8839 = (1f - _e8782);
let _e8841 = (_e8816 + _e8801);
let _e8843 = select(_e2009, _e8841, (_e8841 < _e2009));
let _e8848 = global_3.member[bitcast<u32>(select(0i, _e8843, (_e8843 > 0i)))];
let _e8849 = local_4;
let _e8852 = local_5;
let _e8853 = (_e8841 + _e8852);
let _e8855 = select(_e2009, _e8853, (_e8853 < _e2009));
let _e8860 = global_3.member[bitcast<u32>(select(0i, _e8855, (_e8855 > 0i)))];
let _e8861 = local_4;
let _e8866 = (_e8816 + (((_e8808 - _e8778) * _e8469) * _e8474));
let _e8868 = select(_e2009, _e8866, (_e8866 < _e2009));
let _e8873 = global_3.member[bitcast<u32>(select(0i, _e8868, (_e8868 > 0i)))];
let _e8874 = local_4;
let _e8877 = local_5;
let _e8878 = (_e8866 + _e8877);
let _e8880 = select(_e2009, _e8878, (_e8878 < _e2009));
let _e8885 = global_3.member[bitcast<u32>(select(0i, _e8880, (_e8880 > 0i)))];
let _e8886 = local_4;
let _e8890 = (_e8866 + _e8801);
let _e8892 = select(_e2009, _e8890, (_e8890 < _e2009));
let _e8897 = global_3.member[bitcast<u32>(select(0i, _e8892, (_e8892 > 0i)))];
let _e8898 = local_4;
let _e8901 = local_5;
let _e8902 = (_e8890 + _e8901);
let _e8904 = select(_e2009, _e8902, (_e8902 < _e2009));
let _e8909 = global_3.member[bitcast<u32>(select(0i, _e8904, (_e8904 > 0i)))];
let _e8910 = local_4;
phi_7241_ = (_e8444 + 1u);
phi_7244_ = (_e8446 + ((0.5f * (((((((_e8607 * (1f - _e8608)) + (_e8619 * _e8620)) * _e8623) + (((_e8632 * (1f - _e8633)) + (_e8644 * _e8645)) * _e8561)) * (1f - _e8563)) + (((((_e8657 * (1f - _e8658)) + (_e8669 * _e8670)) * _e8623) + (((_e8681 * (1f - _e8682)) + (_e8693 * _e8694)) * _e8561)) * _e8563)) + ((((((_e8823 * (1f - _e8824)) + (_e8835 * _e8836)) * _e8839) + (((_e8848 * (1f - _e8849)) + (_e8860 * _e8861)) * _e8782)) * (1f - _e8784)) + (((((_e8873 * (1f - _e8874)) + (_e8885 * _e8886)) * _e8839) + (((_e8897 * (1f - _e8898)) + (_e8909 * _e8910)) * _e8782)) * _e8784)))) * _e8456));
} else {
phi_7241_ = u32();
phi_7244_ = f32();
}
let _e8925 = phi_7241_;
let _e8927 = phi_7244_;
continue;
continuing {
phi_7240_ = _e8925;
phi_7243_ = _e8927;
break if !(_e8449);
}
}
let _e10495 = local_71;
phi_7965_ = _e10495;
}
let _e8930 = phi_7965_;
let _e8934 = global_5.member.member_13.member;
let _e8939 = -((_e8934.member * _e8930));
let _e8941 = select(-87f, _e8939, (_e8939 > -87f));
let _e8943 = select(88f, _e8941, (_e8941 < 88f));
let _e8945 = ((_e8943 * 1.442695f) + 0.5f);
let _e8947 = select(-127f, _e8945, (_e8945 > -127f));
let _e8949 = select(128f, _e8947, (_e8947 < 128f));
let _e8956 = select(0i, select(select(i32(_e8949), i32(-2147483648), (_e8949 < -2147483600f)), 2147483647i, (_e8949 > 2147483500f)), (_e8949 == _e8949));
let _e8960 = (_e8956 - select(0i, 1i, (_e8949 < f32(_e8956))));
let _e8961 = f32(_e8960);
let _e8965 = ((_e8943 - (_e8961 * 0.6933594f)) - (_e8961 * -2.1219444e-4f));
let _e8987 = -((_e8934.member_1 * _e8930));
let _e8989 = select(-87f, _e8987, (_e8987 > -87f));
let _e8991 = select(88f, _e8989, (_e8989 < 88f));
let _e8993 = ((_e8991 * 1.442695f) + 0.5f);
let _e8995 = select(-127f, _e8993, (_e8993 > -127f));
let _e8997 = select(128f, _e8995, (_e8995 < 128f));
let _e9004 = select(0i, select(select(i32(_e8997), i32(-2147483648), (_e8997 < -2147483600f)), 2147483647i, (_e8997 > 2147483500f)), (_e8997 == _e8997));
let _e9008 = (_e9004 - select(0i, 1i, (_e8997 < f32(_e9004))));
let _e9009 = f32(_e9008);
let _e9013 = ((_e8991 - (_e9009 * 0.6933594f)) - (_e9009 * -2.1219444e-4f));
let _e9035 = -((_e8934.member_2 * _e8930));
let _e9037 = select(-87f, _e9035, (_e9035 > -87f));
let _e9039 = select(88f, _e9037, (_e9037 < 88f));
let _e9041 = ((_e9039 * 1.442695f) + 0.5f);
let _e9043 = select(-127f, _e9041, (_e9041 > -127f));
let _e9045 = select(128f, _e9043, (_e9043 < 128f));
let _e9052 = select(0i, select(select(i32(_e9045), i32(-2147483648), (_e9045 < -2147483600f)), 2147483647i, (_e9045 > 2147483500f)), (_e9045 == _e9045));
let _e9056 = (_e9052 - select(0i, 1i, (_e9045 < f32(_e9052))));
let _e9057 = f32(_e9056);
let _e9061 = ((_e9039 - (_e9057 * 0.6933594f)) - (_e9057 * -2.1219444e-4f));
let _e9084 = (1f / 3f);
let _e9086 = (1f * ((1f + (_e8965 * (1f + (_e8965 * (0.5f + (_e8965 * (0.16666667f + (_e8965 * (0.041666668f + (_e8965 * (0.008333334f + (_e8965 * (0.001388889f + (_e8965 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e8960 + 127i)) << bitcast<u32>(23i)))));
let _e9087 = (1f * ((1f + (_e9013 * (1f + (_e9013 * (0.5f + (_e9013 * (0.16666667f + (_e9013 * (0.041666668f + (_e9013 * (0.008333334f + (_e9013 * (0.001388889f + (_e9013 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9008 + 127i)) << bitcast<u32>(23i)))));
let _e9088 = (1f * ((1f + (_e9061 * (1f + (_e9061 * (0.5f + (_e9061 * (0.16666667f + (_e9061 * (0.041666668f + (_e9061 * (0.008333334f + (_e9061 * (0.001388889f + (_e9061 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9056 + 127i)) << bitcast<u32>(23i)))));
let _e9117 = type_27(_e8381.member, _e8381.member_1, _e8381.member_2, _e8381.member_3, _e8381.member_4, _e8381.member_5, vec3<f32>(_e9086, _e9087, _e9088), _e8381.member_7, _e8381.member_8, _e8381.member_9, _e8381.member_10, _e8381.member_11, _e8381.member_12, _e8381.member_13, _e8381.member_14, _e8381.member_15, _e8381.member_16, _e8381.member_17, _e8381.member_18, _e8381.member_19, _e8381.member_20, _e8381.member_21, _e8381.member_22, _e8381.member_23, _e8381.member_24, _e8381.member_25, _e8381.member_26, _e8381.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e7619.member_20) {
phi_8193_ = ((((1f + 1f) + 1f) * _e9084) - (((_e9086 + _e9087) + _e9088) * _e9084));
} else {
phi_8193_ = 0f;
}
let _e9127 = phi_8193_;
let _e9157 = type_27(_e9117.member, _e9117.member_1, _e9117.member_2, _e9117.member_3, _e9117.member_4, _e9117.member_5, _e9117.member_6, _e9117.member_7, _e9117.member_8, _e9117.member_9, _e9117.member_10, _e9117.member_11, _e9117.member_12, _e9117.member_13, _e9117.member_14, _e9117.member_15, _e9117.member_16, _e9117.member_17, _e9117.member_18, _e9117.member_19, _e9117.member_20, _e9117.member_21, _e9117.member_22, _e9117.member_23, _e9117.member_24, _e9117.member_25, (_e7619.member_26 + _e9127), _e9117.member_27);
if _e7909 {
phi_8220_ = type_27(_e9157.member, _e9157.member_1, _e9157.member_2, _e9157.member_3, _e9157.member_4, _e9157.member_5, _e9157.member_6, _e9157.member_7, _e1898, _e9157.member_9, _e9157.member_10, _e9157.member_11, _e9157.member_12, _e9157.member_13, _e9157.member_14, _e9157.member_15, _e9157.member_16, _e9157.member_17, _e9157.member_18, _e9157.member_19, _e9157.member_20, _e9157.member_21, _e9157.member_22, _e9157.member_23, _e9157.member_24, _e9157.member_25, _e9157.member_26, _e9157.member_27);
} else {
phi_8220_ = _e9157;
}
let _e9187 = phi_8220_;
phi_8221_ = _e9187;
}
let _e9217 = phi_8221_;
phi_12415_ = _e9217;
phi_12416_ = type_27();
phi_12417_ = true;
} else {
let _e3128 = local_18;
let _e3130 = local_19;
let _e3132 = (!(_e2021) && (_e3128 == _e3130));
if _e3132 {
let _e7061 = type_27(_e3121.member, _e3121.member_1, _e3121.member_2, _e3121.member_3, _e3121.member_4, _e3121.member_5, _e3121.member_6, _e2030, _e3121.member_8, _e3121.member_9, _e3121.member_10, _e3121.member_11, _e3121.member_12, _e3121.member_13, _e3121.member_14, _e3121.member_15, _e3121.member_16, _e3121.member_17, _e3121.member_18, _e3121.member_19, _e3121.member_20, _e3121.member_21, _e3121.member_22, _e3121.member_23, _e3121.member_24, _e3121.member_25, _e3121.member_26, _e3121.member_27);
let _e7092 = type_27(_e7061.member, _e7061.member_1, _e7061.member_2, _e7061.member_3, _e7061.member_4, _e7061.member_5, _e7061.member_6, _e7061.member_7, _e7061.member_8, _e7061.member_9, _e7061.member_10, _e7061.member_11, _e7061.member_12, select(1.1754944e-38f, _e3121.member_14, (_e3121.member_14 > 1.1754944e-38f)), _e7061.member_14, _e7061.member_15, _e7061.member_16, _e7061.member_17, _e7061.member_18, _e7061.member_19, _e7061.member_20, _e7061.member_21, _e7061.member_22, _e7061.member_23, _e7061.member_24, _e7061.member_25, _e7061.member_26, _e7061.member_27);
let _e7120 = type_27(_e7092.member, _e7092.member_1, _e7092.member_2, _e7092.member_3, _e7092.member_4, _e7092.member_5, _e7092.member_6, _e7092.member_7, _e7092.member_8, _e7092.member_9, _e7092.member_10, 0i, _e7092.member_12, _e7092.member_13, _e7092.member_14, _e7092.member_15, _e7092.member_16, _e7092.member_17, _e7092.member_18, _e7092.member_19, _e7092.member_20, _e7092.member_21, _e7092.member_22, _e7092.member_23, _e7092.member_24, _e7092.member_25, _e7092.member_26, _e7092.member_27);
let _e7148 = type_27(_e7120.member, _e7120.member_1, _e7120.member_2, _e7120.member_3, _e7120.member_4, _e7120.member_5, _e7120.member_6, _e7120.member_7, _e7120.member_8, _e7120.member_9, _e7120.member_10, _e7120.member_11, 0i, _e7120.member_13, _e7120.member_14, _e7120.member_15, _e7120.member_16, _e7120.member_17, _e7120.member_18, _e7120.member_19, _e7120.member_20, _e7120.member_21, _e7120.member_22, _e7120.member_23, _e7120.member_24, _e7120.member_25, _e7120.member_26, _e7120.member_27);
let _e7155 = global_5.member.member_14.member.member;
let _e7169 = ((((_e7155.member.member * _e3121.member.x) + (_e7155.member.member_1 * _e3121.member.y)) + (_e7155.member.member_2 * _e3121.member.z)) + _e7155.member_1);
let _e7178 = -((((_e7155.member.member * _e3121.member_1.x) + (_e7155.member.member_1 * _e3121.member_1.y)) + (_e7155.member.member_2 * _e3121.member_1.z)));
let _e7180 = (_e7178 > 1e-9f);
let _e7184 = ((_e7169 / select(1e-9f, _e7178, _e7180)) - 0.015625f);
let _e7187 = select(1e30f, select(0f, _e7184, (_e7184 > 0f)), ((_e7169 > 0f) && _e7180));
let _e7192 = global_5.member.member_14.member_1.member;
let _e7203 = ((((_e7192.member.member * _e3121.member.x) + (_e7192.member.member_1 * _e3121.member.y)) + (_e7192.member.member_2 * _e3121.member.z)) + _e7192.member_1);
let _e7209 = -((((_e7192.member.member * _e3121.member_1.x) + (_e7192.member.member_1 * _e3121.member_1.y)) + (_e7192.member.member_2 * _e3121.member_1.z)));
let _e7211 = (_e7209 > 1e-9f);
let _e7215 = ((_e7203 / select(1e-9f, _e7209, _e7211)) - 0.015625f);
let _e7218 = select(1e30f, select(0f, _e7215, (_e7215 > 0f)), ((_e7203 > 0f) && _e7211));
let _e7222 = (_e7218 < _e7187);
let _e7253 = type_27(_e7148.member, _e7148.member_1, _e7148.member_2, _e7148.member_3, _e7148.member_4, _e7148.member_5, _e7148.member_6, _e7148.member_7, 0i, _e7148.member_9, _e7148.member_10, _e7148.member_11, _e7148.member_12, _e7148.member_13, _e7148.member_14, _e7148.member_15, _e7148.member_16, _e7148.member_17, _e7148.member_18, _e7148.member_19, _e7148.member_20, _e7148.member_21, _e7148.member_22, _e7148.member_23, _e7148.member_24, _e7148.member_25, _e7148.member_26, _e7148.member_27);
let _e7281 = type_27(_e7253.member, _e7253.member_1, _e7253.member_2, _e7253.member_3, _e7253.member_4, _e7253.member_5, _e7253.member_6, _e7253.member_7, _e7253.member_8, select(select(-2i, -3i, _e7222), -1i, ((_e7187 >= 1e30f) && (_e7218 >= 1e30f))), _e7253.member_10, _e7253.member_11, _e7253.member_12, _e7253.member_13, _e7253.member_14, _e7253.member_15, _e7253.member_16, _e7253.member_17, _e7253.member_18, _e7253.member_19, _e7253.member_20, _e7253.member_21, _e7253.member_22, _e7253.member_23, _e7253.member_24, _e7253.member_25, _e7253.member_26, _e7253.member_27);
phi_12413_ = type_27(_e7281.member, _e7281.member_1, _e7281.member_2, _e7281.member_3, _e7281.member_4, _e7281.member_5, _e7281.member_6, _e7281.member_7, _e7281.member_8, _e7281.member_9, select(_e7187, _e7218, _e7222), _e7281.member_11, _e7281.member_12, _e7281.member_13, _e7281.member_14, _e7281.member_15, _e7281.member_16, _e7281.member_17, _e7281.member_18, _e7281.member_19, _e7281.member_20, _e7281.member_21, _e7281.member_22, _e7281.member_23, _e7281.member_24, _e7281.member_25, _e7281.member_26, _e7281.member_27);
phi_12414_ = type_27();
} else {
let _e3143 = (_e3121.member.x + (_e3121.member_1.x * _e3121.member_10));
let _e3146 = (_e3121.member.y + (_e3121.member_1.y * _e3121.member_10));
let _e3149 = (_e3121.member.z + (_e3121.member_1.z * _e3121.member_10));
let _e3178 = type_27(vec3<f32>(_e3143, _e3146, _e3149), _e3121.member_1, _e3121.member_2, _e3121.member_3, _e3121.member_4, _e3121.member_5, _e3121.member_6, _e3121.member_7, _e3121.member_8, _e3121.member_9, _e3121.member_10, _e3121.member_11, _e3121.member_12, _e3121.member_13, _e3121.member_14, _e3121.member_15, _e3121.member_16, _e3121.member_17, _e3121.member_18, _e3121.member_19, _e3121.member_20, _e3121.member_21, _e3121.member_22, _e3121.member_23, _e3121.member_24, _e3121.member_25, _e3121.member_26, _e3121.member_27);
let _e3180 = (_e3121.member_9 * 19i);
let _e3182 = select(_e1991, _e3180, (_e3180 < _e1991));
let _e3188 = global_2.member[bitcast<u32>(select(0i, _e3182, (_e3182 > 0i)))];
let _e3189 = (_e3180 + 1i);
let _e3191 = select(_e1991, _e3189, (_e3189 < _e1991));
let _e3197 = global_2.member[bitcast<u32>(select(0i, _e3191, (_e3191 > 0i)))];
let _e3198 = (_e3180 + 2i);
let _e3200 = select(_e1991, _e3198, (_e3198 < _e1991));
let _e3206 = global_2.member[bitcast<u32>(select(0i, _e3200, (_e3200 > 0i)))];
let _e3207 = (_e3180 + 3i);
let _e3209 = select(_e1991, _e3207, (_e3207 < _e1991));
let _e3215 = global_2.member[bitcast<u32>(select(0i, _e3209, (_e3209 > 0i)))];
let _e3216 = (_e3180 + 4i);
let _e3218 = select(_e1991, _e3216, (_e3216 < _e1991));
let _e3224 = global_2.member[bitcast<u32>(select(0i, _e3218, (_e3218 > 0i)))];
let _e3225 = (_e3180 + 5i);
let _e3227 = select(_e1991, _e3225, (_e3225 < _e1991));
let _e3233 = global_2.member[bitcast<u32>(select(0i, _e3227, (_e3227 > 0i)))];
let _e3234 = (_e3215 - _e3188);
let _e3235 = (_e3224 - _e3197);
let _e3236 = (_e3233 - _e3206);
let _e3237 = (_e3180 + 6i);
let _e3239 = select(_e1991, _e3237, (_e3237 < _e1991));
let _e3245 = global_2.member[bitcast<u32>(select(0i, _e3239, (_e3239 > 0i)))];
let _e3246 = (_e3180 + 7i);
let _e3248 = select(_e1991, _e3246, (_e3246 < _e1991));
let _e3254 = global_2.member[bitcast<u32>(select(0i, _e3248, (_e3248 > 0i)))];
let _e3255 = (_e3180 + 8i);
let _e3257 = select(_e1991, _e3255, (_e3255 < _e1991));
let _e3263 = global_2.member[bitcast<u32>(select(0i, _e3257, (_e3257 > 0i)))];
let _e3264 = (_e3245 - _e3188);
let _e3265 = (_e3254 - _e3197);
let _e3266 = (_e3263 - _e3206);
let _e3269 = ((_e3235 * _e3266) - (_e3236 * _e3265));
let _e3272 = ((_e3236 * _e3264) - (_e3234 * _e3266));
let _e3275 = ((_e3234 * _e3265) - (_e3235 * _e3264));
let _e3280 = (((_e3269 * _e3269) + (_e3272 * _e3272)) + (_e3275 * _e3275));
let _e3292 = (1f / select(1e-30f, _e3280, (_e3280 > 1e-30f)));
let _e3293 = (((_e3265 * _e3275) - (_e3266 * _e3272)) * _e3292);
let _e3294 = (((_e3266 * _e3269) - (_e3264 * _e3275)) * _e3292);
let _e3295 = (((_e3264 * _e3272) - (_e3265 * _e3269)) * _e3292);
let _e3305 = (((_e3272 * _e3236) - (_e3275 * _e3235)) * _e3292);
let _e3306 = (((_e3275 * _e3234) - (_e3269 * _e3236)) * _e3292);
let _e3307 = (((_e3269 * _e3235) - (_e3272 * _e3234)) * _e3292);
let _e3308 = (_e3180 + 9i);
let _e3310 = select(_e1991, _e3308, (_e3308 < _e1991));
let _e3316 = global_2.member[bitcast<u32>(select(0i, _e3310, (_e3310 > 0i)))];
let _e3317 = (_e3180 + 10i);
let _e3319 = select(_e1991, _e3317, (_e3317 < _e1991));
let _e3325 = global_2.member[bitcast<u32>(select(0i, _e3319, (_e3319 > 0i)))];
let _e3326 = (_e3180 + 11i);
let _e3328 = select(_e1991, _e3326, (_e3326 < _e1991));
let _e3334 = global_2.member[bitcast<u32>(select(0i, _e3328, (_e3328 > 0i)))];
let _e3335 = (_e3180 + 12i);
let _e3337 = select(_e1991, _e3335, (_e3335 < _e1991));
let _e3343 = global_2.member[bitcast<u32>(select(0i, _e3337, (_e3337 > 0i)))];
let _e3344 = (_e3180 + 13i);
let _e3346 = select(_e1991, _e3344, (_e3344 < _e1991));
let _e3352 = global_2.member[bitcast<u32>(select(0i, _e3346, (_e3346 > 0i)))];
let _e3353 = (_e3180 + 14i);
let _e3355 = select(_e1991, _e3353, (_e3353 < _e1991));
let _e3361 = global_2.member[bitcast<u32>(select(0i, _e3355, (_e3355 > 0i)))];
let _e3362 = (_e3343 - _e3316);
let _e3363 = (_e3352 - _e3325);
let _e3364 = (_e3361 - _e3334);
let _e3365 = (_e3180 + 15i);
let _e3367 = select(_e1991, _e3365, (_e3365 < _e1991));
let _e3373 = global_2.member[bitcast<u32>(select(0i, _e3367, (_e3367 > 0i)))];
let _e3374 = (_e3180 + 16i);
let _e3376 = select(_e1991, _e3374, (_e3374 < _e1991));
let _e3382 = global_2.member[bitcast<u32>(select(0i, _e3376, (_e3376 > 0i)))];
let _e3383 = (_e3180 + 17i);
let _e3385 = select(_e1991, _e3383, (_e3383 < _e1991));
let _e3391 = global_2.member[bitcast<u32>(select(0i, _e3385, (_e3385 > 0i)))];
let _e3392 = (_e3373 - _e3316);
let _e3393 = (_e3382 - _e3325);
let _e3394 = (_e3391 - _e3334);
let _e3395 = (_e3143 - _e3188);
let _e3396 = (_e3146 - _e3197);
let _e3397 = (_e3149 - _e3206);
let _e3402 = (((_e3293 * _e3395) + (_e3294 * _e3396)) + (_e3295 * _e3397));
let _e3413 = (((_e3305 * _e3395) + (_e3306 * _e3396)) + (_e3307 * _e3397));
let _e3417 = ((_e3316 + (_e3362 * _e3402)) + (_e3392 * _e3413));
let _e3418 = ((_e3325 + (_e3363 * _e3402)) + (_e3393 * _e3413));
let _e3419 = ((_e3334 + (_e3364 * _e3402)) + (_e3394 * _e3413));
let _e3424 = (((_e3417 * _e3417) + (_e3418 * _e3418)) + (_e3419 * _e3419));
let _e3427 = sqrt(select(0f, _e3424, (_e3424 > 0f)));
let _e3430 = (1f / select(1e-20f, _e3427, (_e3427 > 1e-20f)));
let _e3433 = sqrt(select(0f, _e3280, (_e3280 > 0f)));
let _e3436 = (1f / select(1e-20f, _e3433, (_e3433 > 1e-20f)));
let _e3437 = (_e3269 * _e3436);
let _e3438 = (_e3272 * _e3436);
let _e3439 = (_e3275 * _e3436);
let _e3440 = (_e3417 * _e3430);
let _e3441 = (_e3418 * _e3430);
let _e3442 = (_e3419 * _e3430);
if _e2021 {
phi_8843_ = 1f;
phi_8844_ = 1f;
} else {
let _e3444 = local_20;
let _e3445 = (_e3444 * 4i);
let _e3447 = select(_e2009, _e3445, (_e3445 < _e2009));
let _e3453 = global_3.member[bitcast<u32>(select(0i, _e3447, (_e3447 > 0i)))];
let _e3456 = local_21;
let _e3457 = (_e3456 * 4i);
let _e3459 = select(_e2009, _e3457, (_e3457 < _e2009));
let _e3465 = global_3.member[bitcast<u32>(select(0i, _e3459, (_e3459 > 0i)))];
let _e3467 = local_22;
phi_8843_ = select(_e3465, 1f, (_e3467 == 16i));
phi_8844_ = select(_e3453, 1f, _e1964);
}
let _e3471 = phi_8843_;
let _e3473 = phi_8844_;
let _e3480 = select(1f, -1f, ((((_e3121.member_1.x * _e3440) + (_e3121.member_1.y * _e3441)) + (_e3121.member_1.z * _e3442)) > 0f));
let _e3481 = (_e3440 * _e3480);
let _e3482 = (_e3441 * _e3480);
let _e3483 = (_e3442 * _e3480);
let _e3489 = -((((_e3121.member_1.x * _e3481) + (_e3121.member_1.y * _e3482)) + (_e3121.member_1.z * _e3483)));
let _e3491 = select(0f, _e3489, (_e3489 > 0f));
let _e3492 = (_e3473 / _e3471);
let _e3497 = (1f - ((_e3492 * _e3492) * (1f - (_e3491 * _e3491))));
let _e3498 = (_e3497 <= 0f);
let _e3506 = ((_e3492 * _e3491) - sqrt(select(0f, _e3497, (_e3497 > 0f))));
let _e3513 = (2f * _e3491);
let _e3517 = (_e3121.member_1.x + (_e3481 * _e3513));
let _e3518 = (_e3121.member_1.y + (_e3482 * _e3513));
let _e3519 = (_e3121.member_1.z + (_e3483 * _e3513));
let _e3520 = select(((_e3121.member_1.x * _e3492) + (_e3481 * _e3506)), _e3517, _e3498);
let _e3521 = select(((_e3121.member_1.y * _e3492) + (_e3482 * _e3506)), _e3518, _e3498);
let _e3522 = select(((_e3121.member_1.z * _e3492) + (_e3483 * _e3506)), _e3519, _e3498);
let _e3527 = (((_e3520 * _e3520) + (_e3521 * _e3521)) + (_e3522 * _e3522));
let _e3530 = sqrt(select(0f, _e3527, (_e3527 > 0f)));
let _e3533 = (1f / select(1e-20f, _e3530, (_e3530 > 1e-20f)));
let _e3541 = (((_e3121.member_1.x * _e3437) + (_e3121.member_1.y * _e3438)) + (_e3121.member_1.z * _e3439));
let _e3568 = !((((((((_e3440 * _e3121.member_1.x) + (_e3441 * _e3121.member_1.y)) + (_e3442 * _e3121.member_1.z)) * _e3541) > 0f) && (((((((_e3520 * _e3533) * _e3437) + ((_e3521 * _e3533) * _e3438)) + ((_e3522 * _e3533) * _e3439)) * select(1f, -1f, _e3498)) * _e3541) > 0f)) && ((-((((_e3517 * _e3437) + (_e3518 * _e3438)) + (_e3519 * _e3439))) * _e3541) > 0f)));
let _e3569 = select(_e3440, _e3437, _e3568);
let _e3570 = select(_e3441, _e3438, _e3568);
let _e3571 = select(_e3442, _e3439, _e3568);
let _e3572 = select(_e3293, 0f, _e3568);
let _e3573 = select(_e3294, 0f, _e3568);
let _e3574 = select(_e3295, 0f, _e3568);
let _e3575 = select(_e3305, 0f, _e3568);
let _e3576 = select(_e3306, 0f, _e3568);
let _e3577 = select(_e3307, 0f, _e3568);
let _e3589 = (_e3121.member_2.x + (_e3121.member_4.x * _e3121.member_10));
let _e3591 = (_e3121.member_2.y + (_e3121.member_4.y * _e3121.member_10));
let _e3593 = (_e3121.member_2.z + (_e3121.member_4.z * _e3121.member_10));
let _e3601 = (_e3121.member_3.x + (_e3121.member_5.x * _e3121.member_10));
let _e3603 = (_e3121.member_3.y + (_e3121.member_5.y * _e3121.member_10));
let _e3605 = (_e3121.member_3.z + (_e3121.member_5.z * _e3121.member_10));
if ((_e3541 * _e3541) > 1e-12f) {
phi_9077_ = (1f / _e3541);
} else {
phi_9077_ = 0f;
}
let _e3610 = phi_9077_;
let _e3616 = ((((_e3589 * _e3437) + (_e3591 * _e3438)) + (_e3593 * _e3439)) * _e3610);
let _e3620 = (_e3589 - (_e3121.member_1.x * _e3616));
let _e3621 = (_e3591 - (_e3121.member_1.y * _e3616));
let _e3622 = (_e3593 - (_e3121.member_1.z * _e3616));
let _e3623 = vec3<f32>(_e3620, _e3621, _e3622);
let _e3629 = ((((_e3601 * _e3437) + (_e3603 * _e3438)) + (_e3605 * _e3439)) * _e3610);
let _e3633 = (_e3601 - (_e3121.member_1.x * _e3629));
let _e3634 = (_e3603 - (_e3121.member_1.y * _e3629));
let _e3635 = (_e3605 - (_e3121.member_1.z * _e3629));
let _e3636 = vec3<f32>(_e3633, _e3634, _e3635);
let _e3664 = type_27(_e3178.member, _e3178.member_1, _e3623, _e3178.member_3, _e3178.member_4, _e3178.member_5, _e3178.member_6, _e3178.member_7, _e3178.member_8, _e3178.member_9, _e3178.member_10, _e3178.member_11, _e3178.member_12, _e3178.member_13, _e3178.member_14, _e3178.member_15, _e3178.member_16, _e3178.member_17, _e3178.member_18, _e3178.member_19, _e3178.member_20, _e3178.member_21, _e3178.member_22, _e3178.member_23, _e3178.member_24, _e3178.member_25, _e3178.member_26, _e3178.member_27);
let _e3692 = type_27(_e3664.member, _e3664.member_1, _e3664.member_2, _e3636, _e3664.member_4, _e3664.member_5, _e3664.member_6, _e3664.member_7, _e3664.member_8, _e3664.member_9, _e3664.member_10, _e3664.member_11, _e3664.member_12, _e3664.member_13, _e3664.member_14, _e3664.member_15, _e3664.member_16, _e3664.member_17, _e3664.member_18, _e3664.member_19, _e3664.member_20, _e3664.member_21, _e3664.member_22, _e3664.member_23, _e3664.member_24, _e3664.member_25, _e3664.member_26, _e3664.member_27);
let _e3720 = type_27(_e3692.member, _e3692.member_1, _e3692.member_2, _e3692.member_3, _e3121.member_4, _e3692.member_5, _e3692.member_6, _e3692.member_7, _e3692.member_8, _e3692.member_9, _e3692.member_10, _e3692.member_11, _e3692.member_12, _e3692.member_13, _e3692.member_14, _e3692.member_15, _e3692.member_16, _e3692.member_17, _e3692.member_18, _e3692.member_19, _e3692.member_20, _e3692.member_21, _e3692.member_22, _e3692.member_23, _e3692.member_24, _e3692.member_25, _e3692.member_26, _e3692.member_27);
let _e3748 = type_27(_e3720.member, _e3720.member_1, _e3720.member_2, _e3720.member_3, _e3720.member_4, _e3121.member_5, _e3720.member_6, _e3720.member_7, _e3720.member_8, _e3720.member_9, _e3720.member_10, _e3720.member_11, _e3720.member_12, _e3720.member_13, _e3720.member_14, _e3720.member_15, _e3720.member_16, _e3720.member_17, _e3720.member_18, _e3720.member_19, _e3720.member_20, _e3720.member_21, _e3720.member_22, _e3720.member_23, _e3720.member_24, _e3720.member_25, _e3720.member_26, _e3720.member_27);
if _e2021 {
let _e4482 = (_e2007 + 1i);
let _e4484 = select(_e2009, _e4482, (_e4482 < _e2009));
let _e4490 = global_3.member[bitcast<u32>(select(0i, _e4484, (_e4484 > 0i)))];
let _e4491 = (_e2007 + 2i);
let _e4493 = select(_e2009, _e4491, (_e4491 < _e2009));
let _e4499 = global_3.member[bitcast<u32>(select(0i, _e4493, (_e4493 > 0i)))];
let _e4500 = (_e2007 + 3i);
let _e4502 = select(_e2009, _e4500, (_e4500 < _e2009));
let _e4508 = global_3.member[bitcast<u32>(select(0i, _e4502, (_e4502 > 0i)))];
let _e4515 = (1f / 3f);
let _e4519 = (_e3121.member_6.x * _e4490);
let _e4522 = (_e3121.member_6.y * _e4499);
let _e4525 = (_e3121.member_6.z * _e4508);
let _e4554 = type_27(_e3748.member, _e3748.member_1, _e3748.member_2, _e3748.member_3, _e3748.member_4, _e3748.member_5, vec3<f32>(_e4519, _e4522, _e4525), _e3748.member_7, _e3748.member_8, _e3748.member_9, _e3748.member_10, _e3748.member_11, _e3748.member_12, _e3748.member_13, _e3748.member_14, _e3748.member_15, _e3748.member_16, _e3748.member_17, _e3748.member_18, _e3748.member_19, _e3748.member_20, _e3748.member_21, _e3748.member_22, _e3748.member_23, _e3748.member_24, _e3748.member_25, _e3748.member_26, _e3748.member_27);
if (bitcast<i32>(countOneBits(bitcast<u32>((_e3121.member_17 & ((1i << bitcast<u32>((_e3121.member_16 & 31i))) - 1i))))) == _e3121.member_20) {
phi_9208_ = ((((_e3121.member_6.x + _e3121.member_6.y) + _e3121.member_6.z) * _e4515) - (((_e4519 + _e4522) + _e4525) * _e4515));
} else {
phi_9208_ = 0f;
}
let _e4572 = phi_9208_;
let _e4602 = type_27(_e4554.member, _e4554.member_1, _e4554.member_2, _e4554.member_3, _e4554.member_4, _e4554.member_5, _e4554.member_6, _e4554.member_7, _e4554.member_8, _e4554.member_9, _e4554.member_10, _e4554.member_11, _e4554.member_12, _e4554.member_13, _e4554.member_14, _e4554.member_15, _e4554.member_16, _e4554.member_17, _e4554.member_18, _e4554.member_19, _e4554.member_20, _e4554.member_21, _e4554.member_22, _e4554.member_23, _e4554.member_24, (_e3121.member_25 + _e4572), _e4554.member_26, _e4554.member_27);
let _e4609 = select(1f, -1f, ((((_e3569 * _e3121.member_1.x) + (_e3570 * _e3121.member_1.y)) + (_e3571 * _e3121.member_1.z)) > 0f));
let _e4610 = (_e3569 * _e4609);
let _e4611 = (_e3570 * _e4609);
let _e4612 = (_e3571 * _e4609);
let _e4613 = (_e3362 * _e4609);
let _e4614 = (_e3363 * _e4609);
let _e4615 = (_e3364 * _e4609);
let _e4616 = (_e3392 * _e4609);
let _e4617 = (_e3393 * _e4609);
let _e4618 = (_e3394 * _e4609);
let _e4623 = (((_e3572 * _e3620) + (_e3573 * _e3621)) + (_e3574 * _e3622));
let _e4631 = (((_e3575 * _e3620) + (_e3576 * _e3621)) + (_e3577 * _e3622));
let _e4638 = (((_e4613 * _e4623) + (_e4616 * _e4631)) * _e3430);
let _e4639 = (((_e4614 * _e4623) + (_e4617 * _e4631)) * _e3430);
let _e4640 = (((_e4615 * _e4623) + (_e4618 * _e4631)) * _e3430);
let _e4645 = (((_e4610 * _e4638) + (_e4611 * _e4639)) + (_e4612 * _e4640));
let _e4649 = (_e4638 - (_e4610 * _e4645));
let _e4650 = (_e4639 - (_e4611 * _e4645));
let _e4651 = (_e4640 - (_e4612 * _e4645));
let _e4656 = (((_e3121.member_1.x * _e4610) + (_e3121.member_1.y * _e4611)) + (_e3121.member_1.z * _e4612));
let _e4657 = -(_e4656);
let _e4669 = -(((((_e3121.member_4.x * _e4610) + (_e3121.member_4.y * _e4611)) + (_e3121.member_4.z * _e4612)) + (((_e3121.member_1.x * _e4649) + (_e3121.member_1.y * _e4650)) + (_e3121.member_1.z * _e4651))));
let _e4688 = (((_e3572 * _e3633) + (_e3573 * _e3634)) + (_e3574 * _e3635));
let _e4696 = (((_e3575 * _e3633) + (_e3576 * _e3634)) + (_e3577 * _e3635));
let _e4703 = (((_e4613 * _e4688) + (_e4616 * _e4696)) * _e3430);
let _e4704 = (((_e4614 * _e4688) + (_e4617 * _e4696)) * _e3430);
let _e4705 = (((_e4615 * _e4688) + (_e4618 * _e4696)) * _e3430);
let _e4710 = (((_e4610 * _e4703) + (_e4611 * _e4704)) + (_e4612 * _e4705));
let _e4714 = (_e4703 - (_e4610 * _e4710));
let _e4715 = (_e4704 - (_e4611 * _e4710));
let _e4716 = (_e4705 - (_e4612 * _e4710));
let _e4728 = -(((((_e3121.member_5.x * _e4610) + (_e3121.member_5.y * _e4611)) + (_e3121.member_5.z * _e4612)) + (((_e3121.member_1.x * _e4714) + (_e3121.member_1.y * _e4715)) + (_e3121.member_1.z * _e4716))));
let _e4770 = type_27(_e4602.member, _e4602.member_1, _e3623, _e4602.member_3, _e4602.member_4, _e4602.member_5, _e4602.member_6, _e4602.member_7, _e4602.member_8, _e4602.member_9, _e4602.member_10, _e4602.member_11, _e4602.member_12, _e4602.member_13, _e4602.member_14, _e4602.member_15, _e4602.member_16, _e4602.member_17, _e4602.member_18, _e4602.member_19, _e4602.member_20, _e4602.member_21, _e4602.member_22, _e4602.member_23, _e4602.member_24, _e4602.member_25, _e4602.member_26, _e4602.member_27);
let _e4798 = type_27(_e4770.member, _e4770.member_1, _e4770.member_2, _e3636, _e4770.member_4, _e4770.member_5, _e4770.member_6, _e4770.member_7, _e4770.member_8, _e4770.member_9, _e4770.member_10, _e4770.member_11, _e4770.member_12, _e4770.member_13, _e4770.member_14, _e4770.member_15, _e4770.member_16, _e4770.member_17, _e4770.member_18, _e4770.member_19, _e4770.member_20, _e4770.member_21, _e4770.member_22, _e4770.member_23, _e4770.member_24, _e4770.member_25, _e4770.member_26, _e4770.member_27);
let _e4826 = type_27(_e4798.member, _e4798.member_1, _e4798.member_2, _e4798.member_3, (_e3121.member_4 + vec3<f32>((((_e4649 * _e4657) + (_e4610 * _e4669)) * 2f), (((_e4650 * _e4657) + (_e4611 * _e4669)) * 2f), (((_e4651 * _e4657) + (_e4612 * _e4669)) * 2f))), _e4798.member_5, _e4798.member_6, _e4798.member_7, _e4798.member_8, _e4798.member_9, _e4798.member_10, _e4798.member_11, _e4798.member_12, _e4798.member_13, _e4798.member_14, _e4798.member_15, _e4798.member_16, _e4798.member_17, _e4798.member_18, _e4798.member_19, _e4798.member_20, _e4798.member_21, _e4798.member_22, _e4798.member_23, _e4798.member_24, _e4798.member_25, _e4798.member_26, _e4798.member_27);
let _e4854 = type_27(_e4826.member, _e4826.member_1, _e4826.member_2, _e4826.member_3, _e4826.member_4, (_e3121.member_5 + vec3<f32>((((_e4714 * _e4657) + (_e4610 * _e4728)) * 2f), (((_e4715 * _e4657) + (_e4611 * _e4728)) * 2f), (((_e4716 * _e4657) + (_e4612 * _e4728)) * 2f))), _e4826.member_6, _e4826.member_7, _e4826.member_8, _e4826.member_9, _e4826.member_10, _e4826.member_11, _e4826.member_12, _e4826.member_13, _e4826.member_14, _e4826.member_15, _e4826.member_16, _e4826.member_17, _e4826.member_18, _e4826.member_19, _e4826.member_20, _e4826.member_21, _e4826.member_22, _e4826.member_23, _e4826.member_24, _e4826.member_25, _e4826.member_26, _e4826.member_27);
let _e4856 = select(1f, -1f, (_e4656 > 0f));
let _e4857 = (_e4610 * _e4856);
let _e4858 = (_e4611 * _e4856);
let _e4859 = (_e4612 * _e4856);
let _e4865 = -((((_e3121.member_1.x * _e4857) + (_e3121.member_1.y * _e4858)) + (_e3121.member_1.z * _e4859)));
let _e4868 = (2f * select(0f, _e4865, (_e4865 > 0f)));
let _e4901 = type_27(_e4854.member, (_e3121.member_1 + vec3<f32>((_e4857 * _e4868), (_e4858 * _e4868), (_e4859 * _e4868))), _e4854.member_2, _e4854.member_3, _e4854.member_4, _e4854.member_5, _e4854.member_6, _e4854.member_7, _e4854.member_8, _e4854.member_9, _e4854.member_10, _e4854.member_11, _e4854.member_12, _e4854.member_13, _e4854.member_14, _e4854.member_15, _e4854.member_16, _e4854.member_17, _e4854.member_18, _e4854.member_19, _e4854.member_20, _e4854.member_21, _e4854.member_22, _e4854.member_23, _e4854.member_24, _e4854.member_25, _e4854.member_26, _e4854.member_27);
phi_10212_ = type_27(_e4901.member, _e4901.member_1, _e4901.member_2, _e4901.member_3, _e4901.member_4, _e4901.member_5, _e4901.member_6, _e4901.member_7, _e4901.member_8, _e4901.member_9, _e4901.member_10, _e4901.member_11, _e4901.member_12, _e4901.member_13, _e4901.member_14, _e4901.member_15, (_e3121.member_16 + 1i), _e4901.member_17, _e4901.member_18, _e4901.member_19, _e4901.member_20, _e4901.member_21, _e4901.member_22, _e4901.member_23, _e4901.member_24, _e4901.member_25, _e4901.member_26, _e4901.member_27);
} else {
let _e3752 = global_5.member.member_12.member_2;
let _e3754 = local_23;
let _e3755 = (_e3754 * 4i);
let _e3757 = select(_e2009, _e3755, (_e3755 < _e2009));
let _e3763 = global_3.member[bitcast<u32>(select(0i, _e3757, (_e3757 > 0i)))];
let _e3764 = select(_e3763, 1f, _e1964);
let _e3766 = local_24;
let _e3767 = (_e3766 * 4i);
let _e3769 = select(_e2009, _e3767, (_e3767 < _e2009));
let _e3775 = global_3.member[bitcast<u32>(select(0i, _e3769, (_e3769 > 0i)))];
let _e3777 = local_25;
let _e3779 = select(_e3775, 1f, (_e3777 == 16i));
let _e3786 = select(1f, -1f, ((((_e3121.member_1.x * _e3569) + (_e3121.member_1.y * _e3570)) + (_e3121.member_1.z * _e3571)) > 0f));
let _e3787 = (_e3569 * _e3786);
let _e3788 = (_e3570 * _e3786);
let _e3789 = (_e3571 * _e3786);
let _e3795 = -((((_e3121.member_1.x * _e3787) + (_e3121.member_1.y * _e3788)) + (_e3121.member_1.z * _e3789)));
let _e3797 = select(0f, _e3795, (_e3795 > 0f));
let _e3798 = (_e3764 / _e3779);
let _e3799 = (_e3798 * _e3798);
let _e3800 = (_e3797 * _e3797);
let _e3803 = (1f - (_e3799 * (1f - _e3800)));
let _e3804 = (_e3803 <= 0f);
let _e3812 = ((_e3798 * _e3797) - sqrt(select(0f, _e3803, (_e3803 > 0f))));
let _e3819 = (2f * _e3797);
let _e3820 = (_e3787 * _e3819);
let _e3821 = (_e3788 * _e3819);
let _e3822 = (_e3789 * _e3819);
let _e3828 = select(((_e3121.member_1.x * _e3798) + (_e3787 * _e3812)), (_e3121.member_1.x + _e3820), _e3804);
let _e3829 = select(((_e3121.member_1.y * _e3798) + (_e3788 * _e3812)), (_e3121.member_1.y + _e3821), _e3804);
let _e3830 = select(((_e3121.member_1.z * _e3798) + (_e3789 * _e3812)), (_e3121.member_1.z + _e3822), _e3804);
let _e3835 = (((_e3828 * _e3828) + (_e3829 * _e3829)) + (_e3830 * _e3830));
let _e3838 = sqrt(select(0f, _e3835, (_e3835 > 0f)));
let _e3841 = (1f / select(1e-20f, _e3838, (_e3838 > 1e-20f)));
let _e3846 = (_e3779 / _e3764);
let _e3849 = (((_e3846 * _e3846) - 1f) + _e3800);
let _e3852 = sqrt(select(0f, _e3849, (_e3849 > 0f)));
let _e3853 = (_e3852 - _e3797);
let _e3854 = (_e3852 + _e3797);
let _e3857 = (_e3853 / select(1e-6f, _e3854, (_e3854 > 1e-6f)));
let _e3861 = ((_e3797 * _e3853) + 1f);
let _e3864 = (((_e3797 * _e3854) - 1f) / select(1e-6f, _e3861, (_e3861 > 1e-6f)));
let _e3873 = select(select((((0.5f * _e3857) * _e3857) * (1f + (_e3864 * _e3864))), 1f, (_e3849 <= 0f)), 0f, (_e3764 == _e3779));
let _e3876 = (1f - _e3873);
let _e3878 = select(_e3876, _e3873, (_e3873 < _e3876));
let _e3882 = (_e3121.member_16 & 31i);
if (!(_e3804) && (_e3121.member_16 >= _e3121.member_19)) {
let _e3895 = select(_e3121.member_6.y, _e3121.member_6.x, (_e3121.member_6.x > _e3121.member_6.y));
let _e3900 = ((select(_e3121.member_6.z, _e3895, (_e3895 > _e3121.member_6.z)) * _e3878) >= _e3752);
let _e3902 = (1i << bitcast<u32>(_e3882));
if (bitcast<i32>(countOneBits(bitcast<u32>((_e3121.member_17 & (_e3902 - 1i))))) == _e3121.member_20) {
if _e3900 {
phi_9881_ = type_27(_e3748.member, _e3748.member_1, _e3748.member_2, _e3748.member_3, _e3748.member_4, _e3748.member_5, _e3748.member_6, _e3748.member_7, _e3748.member_8, _e3748.member_9, _e3748.member_10, _e3748.member_11, _e3748.member_12, _e3748.member_13, _e3748.member_14, _e3748.member_15, _e3748.member_16, _e3748.member_17, _e3748.member_18, _e3748.member_19, _e3748.member_20, 1i, _e3748.member_22, _e3748.member_23, _e3748.member_24, _e3748.member_25, _e3748.member_26, _e3748.member_27);
} else {
phi_9881_ = type_27(_e3748.member, _e3748.member_1, _e3748.member_2, _e3748.member_3, _e3748.member_4, _e3748.member_5, _e3748.member_6, _e3748.member_7, _e3748.member_8, _e3748.member_9, _e3748.member_10, _e3748.member_11, _e3748.member_12, _e3748.member_13, _e3748.member_14, _e3748.member_15, _e3748.member_16, _e3748.member_17, _e3748.member_18, _e3748.member_19, _e3748.member_20, _e3748.member_21, _e3748.member_22, _e3748.member_23, _e3748.member_24, _e3748.member_25, _e3748.member_26, (_e3121.member_27 + ((((_e3121.member_6.x + _e3121.member_6.y) + _e3121.member_6.z) * (1f / 3f)) * _e3878)));
}
let _e4005 = phi_9881_;
phi_9891_ = _e4005;
} else {
phi_9891_ = type_27(_e3748.member, _e3748.member_1, _e3748.member_2, _e3748.member_3, _e3748.member_4, _e3748.member_5, _e3748.member_6, _e3748.member_7, _e3748.member_8, _e3748.member_9, _e3748.member_10, _e3748.member_11, _e3748.member_12, _e3748.member_13, _e3748.member_14, _e3748.member_15, _e3748.member_16, _e3748.member_17, (_e3121.member_18 | select(0i, _e3902, _e3900)), _e3748.member_19, _e3748.member_20, _e3748.member_21, _e3748.member_22, _e3748.member_23, _e3748.member_24, _e3748.member_25, _e3748.member_26, _e3748.member_27);
}
let _e4007 = phi_9891_;
phi_9892_ = _e4007;
} else {
phi_9892_ = _e3748;
}
let _e4009 = phi_9892_;
let _e4010 = (((_e3121.member_16 < _e3121.member_19) && (((_e3121.member_17 >> bitcast<u32>(_e3882)) & 1i) == 1i)) != (_e3873 > 0.5f));
let _e4011 = (_e3804 || _e4010);
if _e3804 {
phi_9912_ = _e4009;
} else {
let _e4012 = select(_e3876, _e3873, _e4010);
phi_9912_ = type_27(_e4009.member, _e4009.member_1, _e4009.member_2, _e4009.member_3, _e4009.member_4, _e4009.member_5, vec3<f32>((_e4009.member_6.x * _e4012), (_e4009.member_6.y * _e4012), (_e4009.member_6.z * _e4012)), _e4009.member_7, _e4009.member_8, _e4009.member_9, _e4009.member_10, _e4009.member_11, _e4009.member_12, _e4009.member_13, _e4009.member_14, _e4009.member_15, _e4009.member_16, _e4009.member_17, _e4009.member_18, _e4009.member_19, _e4009.member_20, _e4009.member_21, _e4009.member_22, _e4009.member_23, _e4009.member_24, _e4009.member_25, _e4009.member_26, _e4009.member_27);
}
let _e4052 = phi_9912_;
let _e4063 = select(1f, -1f, ((((_e3569 * _e4052.member_1.x) + (_e3570 * _e4052.member_1.y)) + (_e3571 * _e4052.member_1.z)) > 0f));
let _e4064 = (_e3569 * _e4063);
let _e4065 = (_e3570 * _e4063);
let _e4066 = (_e3571 * _e4063);
let _e4067 = (_e3362 * _e4063);
let _e4068 = (_e3363 * _e4063);
let _e4069 = (_e3364 * _e4063);
let _e4070 = (_e3392 * _e4063);
let _e4071 = (_e3393 * _e4063);
let _e4072 = (_e3394 * _e4063);
let _e4084 = (((_e3572 * _e4052.member_2.x) + (_e3573 * _e4052.member_2.y)) + (_e3574 * _e4052.member_2.z));
let _e4092 = (((_e3575 * _e4052.member_2.x) + (_e3576 * _e4052.member_2.y)) + (_e3577 * _e4052.member_2.z));
let _e4099 = (((_e4067 * _e4084) + (_e4070 * _e4092)) * _e3430);
let _e4100 = (((_e4068 * _e4084) + (_e4071 * _e4092)) * _e3430);
let _e4101 = (((_e4069 * _e4084) + (_e4072 * _e4092)) * _e3430);
let _e4106 = (((_e4064 * _e4099) + (_e4065 * _e4100)) + (_e4066 * _e4101));
let _e4110 = (_e4099 - (_e4064 * _e4106));
let _e4111 = (_e4100 - (_e4065 * _e4106));
let _e4112 = (_e4101 - (_e4066 * _e4106));
let _e4118 = -((((_e4052.member_1.x * _e4064) + (_e4052.member_1.y * _e4065)) + (_e4052.member_1.z * _e4066)));
let _e4133 = -(((((_e4052.member_4.x * _e4064) + (_e4052.member_4.y * _e4065)) + (_e4052.member_4.z * _e4066)) + (((_e4052.member_1.x * _e4110) + (_e4052.member_1.y * _e4111)) + (_e4052.member_1.z * _e4112))));
if _e4011 {
phi_10067_ = (_e4052.member_4 + vec3<f32>((((_e4110 * _e4118) + (_e4064 * _e4133)) * 2f), (((_e4111 * _e4118) + (_e4065 * _e4133)) * 2f), (((_e4112 * _e4118) + (_e4066 * _e4133)) * 2f)));
} else {
let _e4137 = (1f - (_e3799 * (1f - (_e4118 * _e4118))));
let _e4139 = select(1e-12f, _e4137, (_e4137 > 1e-12f));
let _e4142 = sqrt(select(0f, _e4139, (_e4139 > 0f)));
let _e4144 = ((_e3798 * _e4118) - _e4142);
let _e4148 = ((_e3798 - ((_e3799 * _e4118) / _e4142)) * _e4133);
phi_10067_ = vec3<f32>((((_e4052.member_4.x * _e3798) + (_e4110 * _e4144)) + (_e4064 * _e4148)), (((_e4052.member_4.y * _e3798) + (_e4111 * _e4144)) + (_e4065 * _e4148)), (((_e4052.member_4.z * _e3798) + (_e4112 * _e4144)) + (_e4066 * _e4148)));
}
let _e4180 = phi_10067_;
let _e4188 = (((_e3572 * _e4052.member_3.x) + (_e3573 * _e4052.member_3.y)) + (_e3574 * _e4052.member_3.z));
let _e4196 = (((_e3575 * _e4052.member_3.x) + (_e3576 * _e4052.member_3.y)) + (_e3577 * _e4052.member_3.z));
let _e4203 = (((_e4067 * _e4188) + (_e4070 * _e4196)) * _e3430);
let _e4204 = (((_e4068 * _e4188) + (_e4071 * _e4196)) * _e3430);
let _e4205 = (((_e4069 * _e4188) + (_e4072 * _e4196)) * _e3430);
let _e4210 = (((_e4064 * _e4203) + (_e4065 * _e4204)) + (_e4066 * _e4205));
let _e4214 = (_e4203 - (_e4064 * _e4210));
let _e4215 = (_e4204 - (_e4065 * _e4210));
let _e4216 = (_e4205 - (_e4066 * _e4210));
let _e4231 = -(((((_e4052.member_5.x * _e4064) + (_e4052.member_5.y * _e4065)) + (_e4052.member_5.z * _e4066)) + (((_e4052.member_1.x * _e4214) + (_e4052.member_1.y * _e4215)) + (_e4052.member_1.z * _e4216))));
if _e4011 {
phi_10193_ = (_e4052.member_5 + vec3<f32>((((_e4214 * _e4118) + (_e4064 * _e4231)) * 2f), (((_e4215 * _e4118) + (_e4065 * _e4231)) * 2f), (((_e4216 * _e4118) + (_e4066 * _e4231)) * 2f)));
} else {
let _e4235 = (1f - (_e3799 * (1f - (_e4118 * _e4118))));
let _e4237 = select(1e-12f, _e4235, (_e4235 > 1e-12f));
let _e4240 = sqrt(select(0f, _e4237, (_e4237 > 0f)));
let _e4242 = ((_e3798 * _e4118) - _e4240);
let _e4246 = ((_e3798 - ((_e3799 * _e4118) / _e4240)) * _e4231);
phi_10193_ = vec3<f32>((((_e4052.member_5.x * _e3798) + (_e4214 * _e4242)) + (_e4064 * _e4246)), (((_e4052.member_5.y * _e3798) + (_e4215 * _e4242)) + (_e4065 * _e4246)), (((_e4052.member_5.z * _e3798) + (_e4216 * _e4242)) + (_e4066 * _e4246)));
}
let _e4278 = phi_10193_;
let _e4306 = type_27(_e4052.member, _e4052.member_1, _e4052.member_2, _e4052.member_3, _e4052.member_4, _e4052.member_5, _e4052.member_6, _e4052.member_7, _e4052.member_8, _e4052.member_9, _e4052.member_10, _e4052.member_11, _e4052.member_12, _e4052.member_13, _e4052.member_14, _e4052.member_15, _e4052.member_16, _e4052.member_17, _e4052.member_18, _e4052.member_19, _e4052.member_20, _e4052.member_21, _e4052.member_22, _e4052.member_23, _e4052.member_24, _e4052.member_25, _e4052.member_26, _e4052.member_27);
let _e4334 = type_27(_e4306.member, _e4306.member_1, _e4306.member_2, _e4052.member_3, _e4306.member_4, _e4306.member_5, _e4306.member_6, _e4306.member_7, _e4306.member_8, _e4306.member_9, _e4306.member_10, _e4306.member_11, _e4306.member_12, _e4306.member_13, _e4306.member_14, _e4306.member_15, _e4306.member_16, _e4306.member_17, _e4306.member_18, _e4306.member_19, _e4306.member_20, _e4306.member_21, _e4306.member_22, _e4306.member_23, _e4306.member_24, _e4306.member_25, _e4306.member_26, _e4306.member_27);
let _e4362 = type_27(_e4334.member, _e4334.member_1, _e4334.member_2, _e4334.member_3, _e4180, _e4334.member_5, _e4334.member_6, _e4334.member_7, _e4334.member_8, _e4334.member_9, _e4334.member_10, _e4334.member_11, _e4334.member_12, _e4334.member_13, _e4334.member_14, _e4334.member_15, _e4334.member_16, _e4334.member_17, _e4334.member_18, _e4334.member_19, _e4334.member_20, _e4334.member_21, _e4334.member_22, _e4334.member_23, _e4334.member_24, _e4334.member_25, _e4334.member_26, _e4334.member_27);
let _e4390 = type_27(_e4362.member, _e4362.member_1, _e4362.member_2, _e4362.member_3, _e4362.member_4, _e4278, _e4362.member_6, _e4362.member_7, _e4362.member_8, _e4362.member_9, _e4362.member_10, _e4362.member_11, _e4362.member_12, _e4362.member_13, _e4362.member_14, _e4362.member_15, _e4362.member_16, _e4362.member_17, _e4362.member_18, _e4362.member_19, _e4362.member_20, _e4362.member_21, _e4362.member_22, _e4362.member_23, _e4362.member_24, _e4362.member_25, _e4362.member_26, _e4362.member_27);
let _e4420 = type_27(_e4390.member, select(vec3<f32>((_e3828 * _e3841), (_e3829 * _e3841), (_e3830 * _e3841)), (_e3121.member_1 + vec3<f32>(_e3820, _e3821, _e3822)), vec3(_e4011)), _e4390.member_2, _e4390.member_3, _e4390.member_4, _e4390.member_5, _e4390.member_6, _e4390.member_7, _e4390.member_8, _e4390.member_9, _e4390.member_10, _e4390.member_11, _e4390.member_12, _e4390.member_13, _e4390.member_14, _e4390.member_15, _e4390.member_16, _e4390.member_17, _e4390.member_18, _e4390.member_19, _e4390.member_20, _e4390.member_21, _e4390.member_22, _e4390.member_23, _e4390.member_24, _e4390.member_25, _e4390.member_26, _e4390.member_27);
let _e4450 = type_27(_e4420.member, _e4420.member_1, _e4420.member_2, _e4420.member_3, _e4420.member_4, _e4420.member_5, _e4420.member_6, _e4420.member_7, _e4420.member_8, _e4420.member_9, _e4420.member_10, _e4420.member_11, _e4420.member_12, _e4420.member_13, _e4420.member_14, _e4420.member_15, (_e4052.member_16 + 1i), _e4420.member_17, _e4420.member_18, _e4420.member_19, _e4420.member_20, _e4420.member_21, _e4420.member_22, _e4420.member_23, _e4420.member_24, _e4420.member_25, _e4420.member_26, _e4420.member_27);
if !(_e4011) {
phi_10211_ = type_27(_e4450.member, _e4450.member_1, _e4450.member_2, _e4450.member_3, _e4450.member_4, _e4450.member_5, _e4450.member_6, _e2030, _e4450.member_8, _e4450.member_9, _e4450.member_10, _e4450.member_11, _e4450.member_12, _e4450.member_13, _e4450.member_14, _e4450.member_15, _e4450.member_16, _e4450.member_17, _e4450.member_18, _e4450.member_19, _e4450.member_20, _e4450.member_21, _e4450.member_22, _e4450.member_23, _e4450.member_24, _e4450.member_25, _e4450.member_26, _e4450.member_27);
} else {
phi_10211_ = _e4450;
}
let _e4481 = phi_10211_;
phi_10212_ = _e4481;
}
let _e4932 = phi_10212_;
let _e4960 = type_27(_e4932.member, _e4932.member_1, _e4932.member_2, _e4932.member_3, _e4932.member_4, _e4932.member_5, _e4932.member_6, _e4932.member_7, _e4932.member_8, _e4932.member_9, _e4932.member_10, _e4932.member_11, _e4932.member_12, 0f, _e4932.member_14, _e4932.member_15, _e4932.member_16, _e4932.member_17, _e4932.member_18, _e4932.member_19, _e4932.member_20, _e4932.member_21, _e4932.member_22, _e4932.member_23, _e4932.member_24, _e4932.member_25, _e4932.member_26, _e4932.member_27);
let _e4988 = type_27(_e4960.member, _e4960.member_1, _e4960.member_2, _e4960.member_3, _e4960.member_4, _e4960.member_5, _e4960.member_6, _e4960.member_7, _e4960.member_8, _e4960.member_9, _e4960.member_10, 0i, _e4960.member_12, _e4960.member_13, _e4960.member_14, _e4960.member_15, _e4960.member_16, _e4960.member_17, _e4960.member_18, _e4960.member_19, _e4960.member_20, _e4960.member_21, _e4960.member_22, _e4960.member_23, _e4960.member_24, _e4960.member_25, _e4960.member_26, _e4960.member_27);
let _e5016 = type_27(_e4988.member, _e4988.member_1, _e4988.member_2, _e4988.member_3, _e4988.member_4, _e4988.member_5, _e4988.member_6, _e4988.member_7, _e4988.member_8, _e4988.member_9, _e4988.member_10, _e4988.member_11, 0i, _e4988.member_13, _e4988.member_14, _e4988.member_15, _e4988.member_16, _e4988.member_17, _e4988.member_18, _e4988.member_19, _e4988.member_20, _e4988.member_21, _e4988.member_22, _e4988.member_23, _e4988.member_24, _e4988.member_25, _e4988.member_26, _e4988.member_27);
let _e5023 = global_5.member.member_14.member.member;
let _e5037 = ((((_e5023.member.member * _e4932.member.x) + (_e5023.member.member_1 * _e4932.member.y)) + (_e5023.member.member_2 * _e4932.member.z)) + _e5023.member_1);
let _e5046 = -((((_e5023.member.member * _e4932.member_1.x) + (_e5023.member.member_1 * _e4932.member_1.y)) + (_e5023.member.member_2 * _e4932.member_1.z)));
let _e5048 = (_e5046 > 1e-9f);
let _e5052 = ((_e5037 / select(1e-9f, _e5046, _e5048)) - 0.015625f);
let _e5055 = select(1e30f, select(0f, _e5052, (_e5052 > 0f)), ((_e5037 > 0f) && _e5048));
let _e5060 = global_5.member.member_14.member_1.member;
let _e5071 = ((((_e5060.member.member * _e4932.member.x) + (_e5060.member.member_1 * _e4932.member.y)) + (_e5060.member.member_2 * _e4932.member.z)) + _e5060.member_1);
let _e5077 = -((((_e5060.member.member * _e4932.member_1.x) + (_e5060.member.member_1 * _e4932.member_1.y)) + (_e5060.member.member_2 * _e4932.member_1.z)));
let _e5079 = (_e5077 > 1e-9f);
let _e5083 = ((_e5071 / select(1e-9f, _e5077, _e5079)) - 0.015625f);
let _e5086 = select(1e30f, select(0f, _e5083, (_e5083 > 0f)), ((_e5071 > 0f) && _e5079));
let _e5090 = (_e5086 < _e5055);
let _e5121 = type_27(_e5016.member, _e5016.member_1, _e5016.member_2, _e5016.member_3, _e5016.member_4, _e5016.member_5, _e5016.member_6, _e5016.member_7, 0i, _e5016.member_9, _e5016.member_10, _e5016.member_11, _e5016.member_12, _e5016.member_13, _e5016.member_14, _e5016.member_15, _e5016.member_16, _e5016.member_17, _e5016.member_18, _e5016.member_19, _e5016.member_20, _e5016.member_21, _e5016.member_22, _e5016.member_23, _e5016.member_24, _e5016.member_25, _e5016.member_26, _e5016.member_27);
let _e5149 = type_27(_e5121.member, _e5121.member_1, _e5121.member_2, _e5121.member_3, _e5121.member_4, _e5121.member_5, _e5121.member_6, _e5121.member_7, _e5121.member_8, select(select(-2i, -3i, _e5090), -1i, ((_e5055 >= 1e30f) && (_e5086 >= 1e30f))), _e5121.member_10, _e5121.member_11, _e5121.member_12, _e5121.member_13, _e5121.member_14, _e5121.member_15, _e5121.member_16, _e5121.member_17, _e5121.member_18, _e5121.member_19, _e5121.member_20, _e5121.member_21, _e5121.member_22, _e5121.member_23, _e5121.member_24, _e5121.member_25, _e5121.member_26, _e5121.member_27);
let _e5177 = type_27(_e5149.member, _e5149.member_1, _e5149.member_2, _e5149.member_3, _e5149.member_4, _e5149.member_5, _e5149.member_6, _e5149.member_7, _e5149.member_8, _e5149.member_9, select(_e5055, _e5086, _e5090), _e5149.member_11, _e5149.member_12, _e5149.member_13, _e5149.member_14, _e5149.member_15, _e5149.member_16, _e5149.member_17, _e5149.member_18, _e5149.member_19, _e5149.member_20, _e5149.member_21, _e5149.member_22, _e5149.member_23, _e5149.member_24, _e5149.member_25, _e5149.member_26, _e5149.member_27);
let _e5182 = global_5.member.member_12.member_3;
if (_e4932.member_16 > bitcast<i32>(_e5182)) {
if (bitcast<i32>(countOneBits(bitcast<u32>((_e4932.member_17 & ((1i << bitcast<u32>((_e4932.member_16 & 31i))) - 1i))))) == _e4932.member_20) {
phi_10367_ = (((_e4932.member_6.x + _e4932.member_6.y) + _e4932.member_6.z) * (1f / 3f));
} else {
phi_10367_ = 0f;
}
let _e5205 = phi_10367_;
let _e5235 = type_27(_e5177.member, _e5177.member_1, _e5177.member_2, _e5177.member_3, _e5177.member_4, _e5177.member_5, _e5177.member_6, _e5177.member_7, _e5177.member_8, _e5177.member_9, _e5177.member_10, _e5177.member_11, _e5177.member_12, _e5177.member_13, _e5177.member_14, _e5177.member_15, _e5177.member_16, _e5177.member_17, _e5177.member_18, _e5177.member_19, _e5177.member_20, _e5177.member_21, _e5177.member_22, _e5177.member_23, _e5177.member_24, _e5177.member_25, _e5177.member_26, (_e4932.member_27 + _e5205));
let _e5237 = (_e4932.member_18 == 0i);
if (_e5237 && (_e4932.member_21 == 0i)) {
phi_12411_ = type_27(_e5235.member, _e5235.member_1, _e5235.member_2, _e5235.member_3, _e5235.member_4, _e5235.member_5, _e5235.member_6, _e5235.member_7, _e5235.member_8, _e5235.member_9, _e5235.member_10, _e5235.member_11, _e5235.member_12, _e5235.member_13, _e5235.member_14, 3f, _e5235.member_16, _e5235.member_17, _e5235.member_18, _e5235.member_19, _e5235.member_20, _e5235.member_21, _e5235.member_22, _e5235.member_23, _e5235.member_24, _e5235.member_25, _e5235.member_26, _e5235.member_27);
} else {
if _e5237 {
let _e5367 = type_27(_e5235.member, _e5235.member_1, _e5235.member_2, _e5235.member_3, _e5235.member_4, _e5235.member_5, _e5235.member_6, _e5235.member_7, _e5235.member_8, _e5235.member_9, _e5235.member_10, _e5235.member_11, _e5235.member_12, _e5235.member_13, _e5235.member_14, _e5235.member_15, _e5235.member_16, _e5235.member_17, _e5235.member_18, _e5235.member_19, (_e4932.member_20 + 1i), _e5235.member_21, _e5235.member_22, _e5235.member_23, _e5235.member_24, _e5235.member_25, _e5235.member_26, _e5235.member_27);
let _e5395 = type_27(_e5367.member, _e5367.member_1, _e5367.member_2, _e5367.member_3, _e5367.member_4, _e5367.member_5, _e5367.member_6, _e5367.member_7, _e5367.member_8, _e5367.member_9, _e5367.member_10, _e5367.member_11, _e5367.member_12, _e5367.member_13, _e5367.member_14, _e5367.member_15, _e5367.member_16, _e5367.member_17, _e5367.member_18, _e5367.member_19, _e5367.member_20, 0i, _e5367.member_22, _e5367.member_23, _e5367.member_24, _e5367.member_25, _e5367.member_26, _e5367.member_27);
let _e5423 = type_27(_e5395.member, _e5395.member_1, _e5395.member_2, _e5395.member_3, _e5395.member_4, _e5395.member_5, _e5395.member_6, _e5395.member_7, _e5395.member_8, _e5395.member_9, _e5395.member_10, _e5395.member_11, _e5395.member_12, _e5395.member_13, _e5395.member_14, _e5395.member_15, _e5395.member_16, 0i, _e5395.member_18, _e5395.member_19, _e5395.member_20, _e5395.member_21, _e5395.member_22, _e5395.member_23, _e5395.member_24, _e5395.member_25, _e5395.member_26, _e5395.member_27);
phi_10411_ = type_27(_e5423.member, _e5423.member_1, _e5423.member_2, _e5423.member_3, _e5423.member_4, _e5423.member_5, _e5423.member_6, _e5423.member_7, _e5423.member_8, _e5423.member_9, _e5423.member_10, _e5423.member_11, _e5423.member_12, _e5423.member_13, _e5423.member_14, _e5423.member_15, _e5423.member_16, _e5423.member_17, _e5423.member_18, 0i, _e5423.member_20, _e5423.member_21, _e5423.member_22, _e5423.member_23, _e5423.member_24, _e5423.member_25, _e5423.member_26, _e5423.member_27);
} else {
let _e5245 = bitcast<i32>((bitcast<u32>(f32(_e4932.member_18)) >> bitcast<u32>(23i)));
let _e5249 = (1i << bitcast<u32>(((_e5245 - 127i) & 31i)));
let _e5250 = (_e5249 - 1i);
let _e5280 = type_27(_e5235.member, _e5235.member_1, _e5235.member_2, _e5235.member_3, _e5235.member_4, _e5235.member_5, _e5235.member_6, _e5235.member_7, _e5235.member_8, _e5235.member_9, _e5235.member_10, _e5235.member_11, _e5235.member_12, _e5235.member_13, _e5235.member_14, _e5235.member_15, _e5235.member_16, ((_e4932.member_17 & _e5250) | _e5249), _e5235.member_18, _e5235.member_19, _e5235.member_20, _e5235.member_21, _e5235.member_22, _e5235.member_23, _e5235.member_24, _e5235.member_25, _e5235.member_26, _e5235.member_27);
let _e5309 = type_27(_e5280.member, _e5280.member_1, _e5280.member_2, _e5280.member_3, _e5280.member_4, _e5280.member_5, _e5280.member_6, _e5280.member_7, _e5280.member_8, _e5280.member_9, _e5280.member_10, _e5280.member_11, _e5280.member_12, _e5280.member_13, _e5280.member_14, _e5280.member_15, _e5280.member_16, _e5280.member_17, (_e4932.member_18 & _e5250), _e5280.member_19, _e5280.member_20, _e5280.member_21, _e5280.member_22, _e5280.member_23, _e5280.member_24, _e5280.member_25, _e5280.member_26, _e5280.member_27);
phi_10411_ = type_27(_e5309.member, _e5309.member_1, _e5309.member_2, _e5309.member_3, _e5309.member_4, _e5309.member_5, _e5309.member_6, _e5309.member_7, _e5309.member_8, _e5309.member_9, _e5309.member_10, _e5309.member_11, _e5309.member_12, _e5309.member_13, _e5309.member_14, _e5309.member_15, _e5309.member_16, _e5309.member_17, _e5309.member_18, (_e5245 + -126i), _e5309.member_20, _e5309.member_21, _e5309.member_22, _e5309.member_23, _e5309.member_24, _e5309.member_25, _e5309.member_26, _e5309.member_27);
}
let _e5453 = phi_10411_;
let _e5459 = global_5.member.member_1.member;
let _e5461 = f32(bitcast<i32>(_e5459));
let _e5465 = global_5.member.member_1.member_1;
let _e5467 = f32(bitcast<i32>(_e5465));
let _e5477 = global_5.member.member_2.member;
let _e5478 = (((((f32(bitcast<i32>(_e140.x)) + 0.5f) / _e5461) * 2f) - 1f) * _e5477);
let _e5486 = global_5.member.member_2.member_1;
let _e5487 = ((1f - (((f32(bitcast<i32>(_e140.y)) + 0.5f) / _e5467) * 2f)) * _e5486);
let _e5490 = global_5.member.member_3;
let _e5499 = global_5.member.member_4;
let _e5506 = ((_e5490.member * _e5478) + (_e5499.member * _e5487));
let _e5507 = ((_e5490.member_1 * _e5478) + (_e5499.member_1 * _e5487));
let _e5508 = ((_e5490.member_2 * _e5478) + (_e5499.member_2 * _e5487));
let _e5512 = global_5.member.member_2.member_3;
let _e5513 = (_e5512 != 0u);
let _e5516 = global_5.member.member_5;
let _e5523 = select((_e5516.member + _e5506), _e5516.member, _e5513);
let _e5524 = select((_e5516.member_1 + _e5507), _e5516.member_1, _e5513);
let _e5525 = select((_e5516.member_2 + _e5508), _e5516.member_2, _e5513);
let _e5528 = global_5.member.member_6;
let _e5535 = select(_e5528.member, (_e5528.member + _e5506), _e5513);
let _e5536 = select(_e5528.member_1, (_e5528.member_1 + _e5507), _e5513);
let _e5537 = select(_e5528.member_2, (_e5528.member_2 + _e5508), _e5513);
let _e5543 = (((_e5523 * _e5523) + (_e5524 * _e5524)) + (_e5525 * _e5525));
let _e5547 = (1f / sqrt(select(0f, _e5543, (_e5543 > 0f))));
let _e5548 = (_e5523 * _e5547);
let _e5549 = (_e5524 * _e5547);
let _e5550 = (_e5525 * _e5547);
let _e5553 = ((2f * _e5477) / _e5461);
let _e5554 = (_e5490.member * _e5553);
let _e5555 = (_e5490.member_1 * _e5553);
let _e5556 = (_e5490.member_2 * _e5553);
let _e5558 = ((-2f * _e5486) / _e5467);
let _e5559 = (_e5499.member * _e5558);
let _e5560 = (_e5499.member_1 * _e5558);
let _e5561 = (_e5499.member_2 * _e5558);
let _e5574 = (((_e5554 * _e5548) + (_e5555 * _e5549)) + (_e5556 * _e5550));
let _e5584 = select(((_e5554 - (_e5548 * _e5574)) * _e5547), 0f, _e5513);
let _e5585 = select(((_e5555 - (_e5549 * _e5574)) * _e5547), 0f, _e5513);
let _e5586 = select(((_e5556 - (_e5550 * _e5574)) * _e5547), 0f, _e5513);
let _e5592 = (((_e5559 * _e5548) + (_e5560 * _e5549)) + (_e5561 * _e5550));
let _e5602 = select(((_e5559 - (_e5548 * _e5592)) * _e5547), 0f, _e5513);
let _e5603 = select(((_e5560 - (_e5549 * _e5592)) * _e5547), 0f, _e5513);
let _e5604 = select(((_e5561 - (_e5550 * _e5592)) * _e5547), 0f, _e5513);
let _e5613 = (1f / select(_e5548, select(1e-12f, -1e-12f, (_e5548 < 0f)), (bitcast<f32>((bitcast<u32>(_e5548) & 2147483647u)) < 1e-12f)));
let _e5621 = (1f / select(_e5549, select(1e-12f, -1e-12f, (_e5549 < 0f)), (bitcast<f32>((bitcast<u32>(_e5549) & 2147483647u)) < 1e-12f)));
let _e5629 = (1f / select(_e5550, select(1e-12f, -1e-12f, (_e5550 < 0f)), (bitcast<f32>((bitcast<u32>(_e5550) & 2147483647u)) < 1e-12f)));
let _e5632 = global_5.member.member_8;
let _e5638 = global_5.member.member_9;
let _e5643 = ((_e5632.member - _e5535) * _e5613);
let _e5645 = ((_e5638.member - _e5535) * _e5613);
let _e5647 = ((_e5632.member_1 - _e5536) * _e5621);
let _e5649 = ((_e5638.member_1 - _e5536) * _e5621);
let _e5651 = ((_e5632.member_2 - _e5537) * _e5629);
let _e5653 = ((_e5638.member_2 - _e5537) * _e5629);
let _e5655 = select(_e5645, _e5643, (_e5643 < _e5645));
let _e5657 = select(_e5649, _e5647, (_e5647 < _e5649));
let _e5659 = select(_e5657, _e5655, (_e5655 > _e5657));
let _e5661 = select(_e5653, _e5651, (_e5651 < _e5653));
let _e5663 = select(_e5661, _e5659, (_e5659 > _e5661));
let _e5665 = select(_e5645, _e5643, (_e5643 > _e5645));
let _e5667 = select(_e5649, _e5647, (_e5647 > _e5649));
let _e5669 = select(_e5667, _e5665, (_e5665 < _e5667));
let _e5671 = select(_e5653, _e5651, (_e5651 > _e5653));
let _e5675 = select(0f, _e5663, (_e5663 > 0f));
let _e5681 = ((((_e5023.member.member * _e5535) + (_e5023.member.member_1 * _e5536)) + (_e5023.member.member_2 * _e5537)) + _e5023.member_1);
let _e5687 = -((((_e5023.member.member * _e5548) + (_e5023.member.member_1 * _e5549)) + (_e5023.member.member_2 * _e5550)));
let _e5689 = (_e5687 > 1e-9f);
let _e5691 = select(1e-9f, _e5687, _e5689);
let _e5693 = ((_e5681 / _e5691) - 0.015625f);
let _e5696 = select(1e30f, select(0f, _e5693, (_e5693 > 0f)), ((_e5681 > 0f) && _e5689));
let _e5702 = ((((_e5060.member.member * _e5535) + (_e5060.member.member_1 * _e5536)) + (_e5060.member.member_2 * _e5537)) + _e5060.member_1);
let _e5708 = -((((_e5060.member.member * _e5548) + (_e5060.member.member_1 * _e5549)) + (_e5060.member.member_2 * _e5550)));
let _e5710 = (_e5708 > 1e-9f);
let _e5712 = select(1e-9f, _e5708, _e5710);
let _e5714 = ((_e5702 / _e5712) - 0.015625f);
let _e5717 = select(1e30f, select(0f, _e5714, (_e5714 > 0f)), ((_e5702 > 0f) && _e5710));
let _e5723 = ((select(_e5671, _e5669, (_e5669 < _e5671)) <= _e5675) || (true && (select(_e5696, _e5717, (_e5717 < _e5696)) <= _e5675)));
let _e5724 = select(_e5675, 0f, _e5723);
let _e5725 = (_e5548 * _e5724);
let _e5726 = (_e5549 * _e5724);
let _e5727 = (_e5550 * _e5724);
let _e5728 = (_e5535 + _e5725);
let _e5729 = (_e5536 + _e5726);
let _e5730 = (_e5537 + _e5727);
let _e5760 = type_27((vec3<f32>(_e5535, _e5536, _e5537) + vec3<f32>(_e5725, _e5726, _e5727)), _e5453.member_1, _e5453.member_2, _e5453.member_3, _e5453.member_4, _e5453.member_5, _e5453.member_6, _e5453.member_7, _e5453.member_8, _e5453.member_9, _e5453.member_10, _e5453.member_11, _e5453.member_12, _e5453.member_13, _e5453.member_14, _e5453.member_15, _e5453.member_16, _e5453.member_17, _e5453.member_18, _e5453.member_19, _e5453.member_20, _e5453.member_21, _e5453.member_22, _e5453.member_23, _e5453.member_24, _e5453.member_25, _e5453.member_26, _e5453.member_27);
let _e5788 = type_27(_e5760.member, vec3<f32>(_e5548, _e5549, _e5550), _e5760.member_2, _e5760.member_3, _e5760.member_4, _e5760.member_5, _e5760.member_6, _e5760.member_7, _e5760.member_8, _e5760.member_9, _e5760.member_10, _e5760.member_11, _e5760.member_12, _e5760.member_13, _e5760.member_14, _e5760.member_15, _e5760.member_16, _e5760.member_17, _e5760.member_18, _e5760.member_19, _e5760.member_20, _e5760.member_21, _e5760.member_22, _e5760.member_23, _e5760.member_24, _e5760.member_25, _e5760.member_26, _e5760.member_27);
let _e5826 = type_27(_e5788.member, _e5788.member_1, (vec3<f32>(select(0f, _e5554, _e5513), select(0f, _e5555, _e5513), select(0f, _e5556, _e5513)) + vec3<f32>((_e5584 * _e5724), (_e5585 * _e5724), (_e5586 * _e5724))), _e5788.member_3, _e5788.member_4, _e5788.member_5, _e5788.member_6, _e5788.member_7, _e5788.member_8, _e5788.member_9, _e5788.member_10, _e5788.member_11, _e5788.member_12, _e5788.member_13, _e5788.member_14, _e5788.member_15, _e5788.member_16, _e5788.member_17, _e5788.member_18, _e5788.member_19, _e5788.member_20, _e5788.member_21, _e5788.member_22, _e5788.member_23, _e5788.member_24, _e5788.member_25, _e5788.member_26, _e5788.member_27);
let _e5854 = type_27(_e5826.member, _e5826.member_1, _e5826.member_2, (vec3<f32>(select(0f, _e5559, _e5513), select(0f, _e5560, _e5513), select(0f, _e5561, _e5513)) + vec3<f32>((_e5602 * _e5724), (_e5603 * _e5724), (_e5604 * _e5724))), _e5826.member_4, _e5826.member_5, _e5826.member_6, _e5826.member_7, _e5826.member_8, _e5826.member_9, _e5826.member_10, _e5826.member_11, _e5826.member_12, _e5826.member_13, _e5826.member_14, _e5826.member_15, _e5826.member_16, _e5826.member_17, _e5826.member_18, _e5826.member_19, _e5826.member_20, _e5826.member_21, _e5826.member_22, _e5826.member_23, _e5826.member_24, _e5826.member_25, _e5826.member_26, _e5826.member_27);
let _e5882 = type_27(_e5854.member, _e5854.member_1, _e5854.member_2, _e5854.member_3, vec3<f32>(_e5584, _e5585, _e5586), _e5854.member_5, _e5854.member_6, _e5854.member_7, _e5854.member_8, _e5854.member_9, _e5854.member_10, _e5854.member_11, _e5854.member_12, _e5854.member_13, _e5854.member_14, _e5854.member_15, _e5854.member_16, _e5854.member_17, _e5854.member_18, _e5854.member_19, _e5854.member_20, _e5854.member_21, _e5854.member_22, _e5854.member_23, _e5854.member_24, _e5854.member_25, _e5854.member_26, _e5854.member_27);
let _e5910 = type_27(_e5882.member, _e5882.member_1, _e5882.member_2, _e5882.member_3, _e5882.member_4, vec3<f32>(_e5602, _e5603, _e5604), _e5882.member_6, _e5882.member_7, _e5882.member_8, _e5882.member_9, _e5882.member_10, _e5882.member_11, _e5882.member_12, _e5882.member_13, _e5882.member_14, _e5882.member_15, _e5882.member_16, _e5882.member_17, _e5882.member_18, _e5882.member_19, _e5882.member_20, _e5882.member_21, _e5882.member_22, _e5882.member_23, _e5882.member_24, _e5882.member_25, _e5882.member_26, _e5882.member_27);
let _e5938 = type_27(_e5910.member, _e5910.member_1, _e5910.member_2, _e5910.member_3, _e5910.member_4, _e5910.member_5, _e5910.member_6, 0i, _e5910.member_8, _e5910.member_9, _e5910.member_10, _e5910.member_11, _e5910.member_12, _e5910.member_13, _e5910.member_14, _e5910.member_15, _e5910.member_16, _e5910.member_17, _e5910.member_18, _e5910.member_19, _e5910.member_20, _e5910.member_21, _e5910.member_22, _e5910.member_23, _e5910.member_24, _e5910.member_25, _e5910.member_26, _e5910.member_27);
let _e5966 = type_27(_e5938.member, _e5938.member_1, _e5938.member_2, _e5938.member_3, _e5938.member_4, _e5938.member_5, _e5938.member_6, _e5938.member_7, _e5938.member_8, _e5938.member_9, _e5938.member_10, _e5938.member_11, _e5938.member_12, _e5938.member_13, _e5938.member_14, _e5938.member_15, 0i, _e5938.member_17, _e5938.member_18, _e5938.member_19, _e5938.member_20, _e5938.member_21, _e5938.member_22, _e5938.member_23, _e5938.member_24, _e5938.member_25, _e5938.member_26, _e5938.member_27);
let _e5994 = type_27(_e5966.member, _e5966.member_1, _e5966.member_2, _e5966.member_3, _e5966.member_4, _e5966.member_5, _e5966.member_6, _e5966.member_7, _e5966.member_8, _e5966.member_9, _e5966.member_10, _e5966.member_11, _e5966.member_12, _e5966.member_13, _e5966.member_14, 1f, _e5966.member_16, _e5966.member_17, _e5966.member_18, _e5966.member_19, _e5966.member_20, _e5966.member_21, _e5966.member_22, _e5966.member_23, _e5966.member_24, _e5966.member_25, _e5966.member_26, _e5966.member_27);
let _e6022 = type_27(_e5994.member, _e5994.member_1, _e5994.member_2, _e5994.member_3, _e5994.member_4, _e5994.member_5, _e5994.member_6, _e5994.member_7, _e5994.member_8, _e5994.member_9, _e5994.member_10, _e5994.member_11, _e5994.member_12, 0f, _e5994.member_14, _e5994.member_15, _e5994.member_16, _e5994.member_17, _e5994.member_18, _e5994.member_19, _e5994.member_20, _e5994.member_21, _e5994.member_22, _e5994.member_23, _e5994.member_24, _e5994.member_25, _e5994.member_26, _e5994.member_27);
let _e6050 = type_27(_e6022.member, _e6022.member_1, _e6022.member_2, _e6022.member_3, _e6022.member_4, _e6022.member_5, _e6022.member_6, _e6022.member_7, _e6022.member_8, _e6022.member_9, _e6022.member_10, 0i, _e6022.member_12, _e6022.member_13, _e6022.member_14, _e6022.member_15, _e6022.member_16, _e6022.member_17, _e6022.member_18, _e6022.member_19, _e6022.member_20, _e6022.member_21, _e6022.member_22, _e6022.member_23, _e6022.member_24, _e6022.member_25, _e6022.member_26, _e6022.member_27);
let _e6078 = type_27(_e6050.member, _e6050.member_1, _e6050.member_2, _e6050.member_3, _e6050.member_4, _e6050.member_5, _e6050.member_6, _e6050.member_7, _e6050.member_8, _e6050.member_9, _e6050.member_10, _e6050.member_11, 0i, _e6050.member_13, _e6050.member_14, _e6050.member_15, _e6050.member_16, _e6050.member_17, _e6050.member_18, _e6050.member_19, _e6050.member_20, _e6050.member_21, _e6050.member_22, _e6050.member_23, _e6050.member_24, _e6050.member_25, _e6050.member_26, _e6050.member_27);
let _e6084 = ((((_e5023.member.member * _e5728) + (_e5023.member.member_1 * _e5729)) + (_e5023.member.member_2 * _e5730)) + _e5023.member_1);
let _e6088 = ((_e6084 / _e5691) - 0.015625f);
let _e6091 = select(1e30f, select(0f, _e6088, (_e6088 > 0f)), ((_e6084 > 0f) && _e5689));
let _e6097 = ((((_e5060.member.member * _e5728) + (_e5060.member.member_1 * _e5729)) + (_e5060.member.member_2 * _e5730)) + _e5060.member_1);
let _e6101 = ((_e6097 / _e5712) - 0.015625f);
let _e6104 = select(1e30f, select(0f, _e6101, (_e6101 > 0f)), ((_e6097 > 0f) && _e5710));
let _e6108 = (_e6104 < _e6091);
let _e6139 = type_27(_e6078.member, _e6078.member_1, _e6078.member_2, _e6078.member_3, _e6078.member_4, _e6078.member_5, _e6078.member_6, _e6078.member_7, 0i, _e6078.member_9, _e6078.member_10, _e6078.member_11, _e6078.member_12, _e6078.member_13, _e6078.member_14, _e6078.member_15, _e6078.member_16, _e6078.member_17, _e6078.member_18, _e6078.member_19, _e6078.member_20, _e6078.member_21, _e6078.member_22, _e6078.member_23, _e6078.member_24, _e6078.member_25, _e6078.member_26, _e6078.member_27);
let _e6167 = type_27(_e6139.member, _e6139.member_1, _e6139.member_2, _e6139.member_3, _e6139.member_4, _e6139.member_5, _e6139.member_6, _e6139.member_7, _e6139.member_8, select(select(-2i, -3i, _e6108), -1i, ((_e6091 >= 1e30f) && (_e6104 >= 1e30f))), _e6139.member_10, _e6139.member_11, _e6139.member_12, _e6139.member_13, _e6139.member_14, _e6139.member_15, _e6139.member_16, _e6139.member_17, _e6139.member_18, _e6139.member_19, _e6139.member_20, _e6139.member_21, _e6139.member_22, _e6139.member_23, _e6139.member_24, _e6139.member_25, _e6139.member_26, _e6139.member_27);
let _e6195 = type_27(_e6167.member, _e6167.member_1, _e6167.member_2, _e6167.member_3, _e6167.member_4, _e6167.member_5, _e6167.member_6, _e6167.member_7, _e6167.member_8, _e6167.member_9, select(_e6091, _e6104, _e6108), _e6167.member_11, _e6167.member_12, _e6167.member_13, _e6167.member_14, _e6167.member_15, _e6167.member_16, _e6167.member_17, _e6167.member_18, _e6167.member_19, _e6167.member_20, _e6167.member_21, _e6167.member_22, _e6167.member_23, _e6167.member_24, _e6167.member_25, _e6167.member_26, _e6167.member_27);
let _e6199 = global_5.member.member_13.member_4;
let _e6206 = global_5.member.member_13.member_5;
let _e6211 = ((_e6199.member - _e5535) * _e5613);
let _e6213 = ((_e6206.member - _e5535) * _e5613);
let _e6215 = ((_e6199.member_1 - _e5536) * _e5621);
let _e6217 = ((_e6206.member_1 - _e5536) * _e5621);
let _e6219 = ((_e6199.member_2 - _e5537) * _e5629);
let _e6221 = ((_e6206.member_2 - _e5537) * _e5629);
let _e6223 = select(_e6213, _e6211, (_e6211 < _e6213));
let _e6225 = select(_e6217, _e6215, (_e6215 < _e6217));
let _e6227 = select(_e6225, _e6223, (_e6223 > _e6225));
let _e6229 = select(_e6221, _e6219, (_e6219 < _e6221));
let _e6231 = select(_e6229, _e6227, (_e6227 > _e6229));
let _e6233 = select(_e6213, _e6211, (_e6211 > _e6213));
let _e6235 = select(_e6217, _e6215, (_e6215 > _e6217));
let _e6237 = select(_e6235, _e6233, (_e6233 < _e6235));
let _e6239 = select(_e6221, _e6219, (_e6219 > _e6221));
let _e6241 = select(_e6239, _e6237, (_e6237 < _e6239));
let _e6243 = select(0f, _e6231, (_e6231 > 0f));
let _e6245 = select(_e5724, _e6241, (_e6241 < _e5724));
let _e6246 = (_e6245 > _e6243);
let _e6247 = select(0f, _e6243, _e6246);
let _e6249 = (select(0f, _e6245, _e6246) - _e6247);
let _e6253 = global_5.member.member_13.member_6;
if (_e6253 == 0u) {
phi_12155_ = _e6249;
} else {
let _e6256 = (_e6249 / f32(_e6253));
phi_11430_ = 0u;
phi_11433_ = 0f;
loop {
let _e6258 = phi_11430_;
let _e6260 = phi_11433_;
local_70 = _e6260;
let _e6263 = ((_e6258 < _e6253) && (_e6249 > 0f));
if _e6263 {
let _e6266 = (_e6247 + (_e6256 * f32(_e6258)));
let _e6267 = (_e6266 + _e6256);
let _e6269 = (0.5f * (_e6266 + _e6267));
let _e6270 = (_e6267 - _e6266);
let _e6271 = (0.28867513f * _e6270);
let _e6272 = (_e6269 - _e6271);
let _e6282 = global_5.member.member_13.member_7;
let _e6283 = bitcast<i32>(_e6282);
let _e6287 = global_5.member.member_13.member_8;
let _e6288 = bitcast<i32>(_e6287);
let _e6292 = global_5.member.member_13.member_9;
let _e6293 = bitcast<i32>(_e6292);
let _e6294 = f32(_e6283);
let _e6296 = (_e6206.member - _e6199.member);
let _e6299 = (((((_e5535 + (_e5548 * _e6272)) - _e6199.member) / _e6296) * _e6294) - 0.5f);
let _e6300 = (_e6294 - 1f);
let _e6302 = select(0f, _e6299, (_e6299 > 0f));
let _e6304 = select(_e6300, _e6302, (_e6302 < _e6300));
let _e6305 = f32(_e6288);
let _e6307 = (_e6206.member_1 - _e6199.member_1);
let _e6310 = (((((_e5536 + (_e5549 * _e6272)) - _e6199.member_1) / _e6307) * _e6305) - 0.5f);
let _e6311 = (_e6305 - 1f);
let _e6313 = select(0f, _e6310, (_e6310 > 0f));
let _e6315 = select(_e6311, _e6313, (_e6313 < _e6311));
let _e6316 = f32(_e6293);
let _e6318 = (_e6206.member_2 - _e6199.member_2);
let _e6321 = (((((_e5537 + (_e5550 * _e6272)) - _e6199.member_2) / _e6318) * _e6316) - 0.5f);
let _e6322 = (_e6316 - 1f);
let _e6324 = select(0f, _e6321, (_e6321 > 0f));
let _e6326 = select(_e6322, _e6324, (_e6324 < _e6322));
let _e6328 = select(0f, _e6304, (_e6304 > 0f));
let _e6330 = select(1e6f, _e6328, (_e6328 < 1e6f));
let _e6337 = select(0i, select(select(i32(_e6330), i32(-2147483648), (_e6330 < -2147483600f)), 2147483647i, (_e6330 > 2147483500f)), (_e6330 == _e6330));
let _e6341 = (_e6337 - select(0i, 1i, (_e6330 < f32(_e6337))));
let _e6343 = select(0f, _e6315, (_e6315 > 0f));
let _e6345 = select(1e6f, _e6343, (_e6343 < 1e6f));
let _e6352 = select(0i, select(select(i32(_e6345), i32(-2147483648), (_e6345 < -2147483600f)), 2147483647i, (_e6345 > 2147483500f)), (_e6345 == _e6345));
let _e6356 = (_e6352 - select(0i, 1i, (_e6345 < f32(_e6352))));
let _e6358 = select(0f, _e6326, (_e6326 > 0f));
let _e6360 = select(1e6f, _e6358, (_e6358 < 1e6f));
let _e6367 = select(0i, select(select(i32(_e6360), i32(-2147483648), (_e6360 < -2147483600f)), 2147483647i, (_e6360 > 2147483500f)), (_e6360 == _e6360));
let _e6371 = (_e6367 - select(0i, 1i, (_e6360 < f32(_e6367))));
let _e6375 = (_e6315 - f32(_e6356));
let _e6377 = (_e6326 - f32(_e6371));
local_2 = (_e6304 - f32(_e6341));
let _e6378 = (_e6341 + 1i);
let _e6380 = select(_e6378, 0i, (_e6378 < 0i));
if (_e6380 >= _e6283) {
phi_11574_ = (_e6283 - 1i);
} else {
phi_11574_ = _e6380;
}
let _e6384 = phi_11574_;
local_3 = (_e6384 - _e6341);
let _e6386 = (_e6356 + 1i);
let _e6388 = select(_e6386, 0i, (_e6386 < 0i));
if (_e6388 >= _e6288) {
phi_11587_ = (_e6288 - 1i);
} else {
phi_11587_ = _e6388;
}
let _e6392 = phi_11587_;
let _e6394 = ((_e6392 - _e6356) * _e6283);
let _e6395 = (_e6371 + 1i);
let _e6397 = select(_e6395, 0i, (_e6395 < 0i));
if (_e6397 >= _e6293) {
phi_11601_ = (_e6293 - 1i);
} else {
phi_11601_ = _e6397;
}
let _e6401 = phi_11601_;
let _e6408 = global_5.member.member_13.member_10;
let _e6409 = bitcast<i32>(_e6408);
let _e6414 = ((_e6409 + (((_e6371 * _e6288) + _e6356) * _e6283)) + _e6341);
let _e6416 = select(_e2009, _e6414, (_e6414 < _e2009));
let _e6421 = global_3.member[bitcast<u32>(select(0i, _e6416, (_e6416 > 0i)))];
let _e6422 = local_2;
let _e6425 = local_3;
let _e6426 = (_e6414 + _e6425);
let _e6428 = select(_e2009, _e6426, (_e6426 < _e2009));
let _e6433 = global_3.member[bitcast<u32>(select(0i, _e6428, (_e6428 > 0i)))];
let _e6434 = local_2;
let _e6437 = (1f - _e6375);
let _e6439 = (_e6414 + _e6394);
let _e6441 = select(_e2009, _e6439, (_e6439 < _e2009));
let _e6446 = global_3.member[bitcast<u32>(select(0i, _e6441, (_e6441 > 0i)))];
let _e6447 = local_2;
let _e6450 = local_3;
let _e6451 = (_e6439 + _e6450);
let _e6453 = select(_e2009, _e6451, (_e6451 < _e2009));
let _e6458 = global_3.member[bitcast<u32>(select(0i, _e6453, (_e6453 > 0i)))];
let _e6459 = local_2;
let _e6464 = (_e6414 + (((_e6401 - _e6371) * _e6283) * _e6288));
let _e6466 = select(_e2009, _e6464, (_e6464 < _e2009));
let _e6471 = global_3.member[bitcast<u32>(select(0i, _e6466, (_e6466 > 0i)))];
let _e6472 = local_2;
let _e6475 = local_3;
let _e6476 = (_e6464 + _e6475);
let _e6478 = select(_e2009, _e6476, (_e6476 < _e2009));
let _e6483 = global_3.member[bitcast<u32>(select(0i, _e6478, (_e6478 > 0i)))];
let _e6484 = local_2;
let _e6488 = (_e6464 + _e6394);
let _e6490 = select(_e2009, _e6488, (_e6488 < _e2009));
let _e6495 = global_3.member[bitcast<u32>(select(0i, _e6490, (_e6490 > 0i)))];
let _e6496 = local_2;
let _e6499 = local_3;
let _e6500 = (_e6488 + _e6499);
let _e6502 = select(_e2009, _e6500, (_e6500 < _e2009));
let _e6507 = global_3.member[bitcast<u32>(select(0i, _e6502, (_e6502 > 0i)))];
let _e6508 = local_2;
let _e6517 = (_e6269 + _e6271);
let _e6527 = (((((_e5535 + (_e5548 * _e6517)) - _e6199.member) / _e6296) * _e6294) - 0.5f);
let _e6529 = select(0f, _e6527, (_e6527 > 0f));
let _e6531 = select(_e6300, _e6529, (_e6529 < _e6300));
let _e6535 = (((((_e5536 + (_e5549 * _e6517)) - _e6199.member_1) / _e6307) * _e6305) - 0.5f);
let _e6537 = select(0f, _e6535, (_e6535 > 0f));
let _e6539 = select(_e6311, _e6537, (_e6537 < _e6311));
let _e6543 = (((((_e5537 + (_e5550 * _e6517)) - _e6199.member_2) / _e6318) * _e6316) - 0.5f);
let _e6545 = select(0f, _e6543, (_e6543 > 0f));
let _e6547 = select(_e6322, _e6545, (_e6545 < _e6322));
let _e6549 = select(0f, _e6531, (_e6531 > 0f));
let _e6551 = select(1e6f, _e6549, (_e6549 < 1e6f));
let _e6558 = select(0i, select(select(i32(_e6551), i32(-2147483648), (_e6551 < -2147483600f)), 2147483647i, (_e6551 > 2147483500f)), (_e6551 == _e6551));
let _e6562 = (_e6558 - select(0i, 1i, (_e6551 < f32(_e6558))));
let _e6564 = select(0f, _e6539, (_e6539 > 0f));
let _e6566 = select(1e6f, _e6564, (_e6564 < 1e6f));
let _e6573 = select(0i, select(select(i32(_e6566), i32(-2147483648), (_e6566 < -2147483600f)), 2147483647i, (_e6566 > 2147483500f)), (_e6566 == _e6566));
let _e6577 = (_e6573 - select(0i, 1i, (_e6566 < f32(_e6573))));
let _e6579 = select(0f, _e6547, (_e6547 > 0f));
let _e6581 = select(1e6f, _e6579, (_e6579 < 1e6f));
let _e6588 = select(0i, select(select(i32(_e6581), i32(-2147483648), (_e6581 < -2147483600f)), 2147483647i, (_e6581 > 2147483500f)), (_e6581 == _e6581));
let _e6592 = (_e6588 - select(0i, 1i, (_e6581 < f32(_e6588))));
let _e6596 = (_e6539 - f32(_e6577));
let _e6598 = (_e6547 - f32(_e6592));
local = (_e6531 - f32(_e6562));
let _e6599 = (_e6562 + 1i);
let _e6601 = select(_e6599, 0i, (_e6599 < 0i));
if (_e6601 >= _e6283) {
phi_11923_ = (_e6283 - 1i);
} else {
phi_11923_ = _e6601;
}
let _e6605 = phi_11923_;
local_1 = (_e6605 - _e6562);
let _e6607 = (_e6577 + 1i);
let _e6609 = select(_e6607, 0i, (_e6607 < 0i));
if (_e6609 >= _e6288) {
phi_11936_ = (_e6288 - 1i);
} else {
phi_11936_ = _e6609;
}
let _e6613 = phi_11936_;
let _e6615 = ((_e6613 - _e6577) * _e6283);
let _e6616 = (_e6592 + 1i);
let _e6618 = select(_e6616, 0i, (_e6616 < 0i));
if (_e6618 >= _e6293) {
phi_11950_ = (_e6293 - 1i);
} else {
phi_11950_ = _e6618;
}
let _e6622 = phi_11950_;
let _e6630 = ((_e6409 + (((_e6592 * _e6288) + _e6577) * _e6283)) + _e6562);
let _e6632 = select(_e2009, _e6630, (_e6630 < _e2009));
let _e6637 = global_3.member[bitcast<u32>(select(0i, _e6632, (_e6632 > 0i)))];
let _e6638 = local;
let _e6641 = local_1;
let _e6642 = (_e6630 + _e6641);
let _e6644 = select(_e2009, _e6642, (_e6642 < _e2009));
let _e6649 = global_3.member[bitcast<u32>(select(0i, _e6644, (_e6644 > 0i)))];
let _e6650 = local;
let _e6653 = (1f - _e6596);
let _e6655 = (_e6630 + _e6615);
let _e6657 = select(_e2009, _e6655, (_e6655 < _e2009));
let _e6662 = global_3.member[bitcast<u32>(select(0i, _e6657, (_e6657 > 0i)))];
let _e6663 = local;
let _e6666 = local_1;
let _e6667 = (_e6655 + _e6666);
let _e6669 = select(_e2009, _e6667, (_e6667 < _e2009));
let _e6674 = global_3.member[bitcast<u32>(select(0i, _e6669, (_e6669 > 0i)))];
let _e6675 = local;
let _e6680 = (_e6630 + (((_e6622 - _e6592) * _e6283) * _e6288));
let _e6682 = select(_e2009, _e6680, (_e6680 < _e2009));
let _e6687 = global_3.member[bitcast<u32>(select(0i, _e6682, (_e6682 > 0i)))];
let _e6688 = local;
let _e6691 = local_1;
let _e6692 = (_e6680 + _e6691);
let _e6694 = select(_e2009, _e6692, (_e6692 < _e2009));
let _e6699 = global_3.member[bitcast<u32>(select(0i, _e6694, (_e6694 > 0i)))];
let _e6700 = local;
let _e6704 = (_e6680 + _e6615);
let _e6706 = select(_e2009, _e6704, (_e6704 < _e2009));
let _e6711 = global_3.member[bitcast<u32>(select(0i, _e6706, (_e6706 > 0i)))];
let _e6712 = local;
let _e6715 = local_1;
let _e6716 = (_e6704 + _e6715);
let _e6718 = select(_e2009, _e6716, (_e6716 < _e2009));
let _e6723 = global_3.member[bitcast<u32>(select(0i, _e6718, (_e6718 > 0i)))];
let _e6724 = local;
phi_11431_ = (_e6258 + 1u);
phi_11434_ = (_e6260 + ((0.5f * (((((((_e6421 * (1f - _e6422)) + (_e6433 * _e6434)) * _e6437) + (((_e6446 * (1f - _e6447)) + (_e6458 * _e6459)) * _e6375)) * (1f - _e6377)) + (((((_e6471 * (1f - _e6472)) + (_e6483 * _e6484)) * _e6437) + (((_e6495 * (1f - _e6496)) + (_e6507 * _e6508)) * _e6375)) * _e6377)) + ((((((_e6637 * (1f - _e6638)) + (_e6649 * _e6650)) * _e6653) + (((_e6662 * (1f - _e6663)) + (_e6674 * _e6675)) * _e6596)) * (1f - _e6598)) + (((((_e6687 * (1f - _e6688)) + (_e6699 * _e6700)) * _e6653) + (((_e6711 * (1f - _e6712)) + (_e6723 * _e6724)) * _e6596)) * _e6598)))) * _e6270));
} else {
phi_11431_ = u32();
phi_11434_ = f32();
}
let _e6739 = phi_11431_;
let _e6741 = phi_11434_;
continue;
continuing {
phi_11430_ = _e6739;
phi_11433_ = _e6741;
break if !(_e6263);
}
}
let _e10473 = local_70;
phi_12155_ = _e10473;
}
let _e6744 = phi_12155_;
let _e6748 = global_5.member.member_13.member;
let _e6753 = -((_e6748.member * _e6744));
let _e6755 = select(-87f, _e6753, (_e6753 > -87f));
let _e6757 = select(88f, _e6755, (_e6755 < 88f));
let _e6759 = ((_e6757 * 1.442695f) + 0.5f);
let _e6761 = select(-127f, _e6759, (_e6759 > -127f));
let _e6763 = select(128f, _e6761, (_e6761 < 128f));
let _e6770 = select(0i, select(select(i32(_e6763), i32(-2147483648), (_e6763 < -2147483600f)), 2147483647i, (_e6763 > 2147483500f)), (_e6763 == _e6763));
let _e6774 = (_e6770 - select(0i, 1i, (_e6763 < f32(_e6770))));
let _e6775 = f32(_e6774);
let _e6779 = ((_e6757 - (_e6775 * 0.6933594f)) - (_e6775 * -2.1219444e-4f));
let _e6801 = -((_e6748.member_1 * _e6744));
let _e6803 = select(-87f, _e6801, (_e6801 > -87f));
let _e6805 = select(88f, _e6803, (_e6803 < 88f));
let _e6807 = ((_e6805 * 1.442695f) + 0.5f);
let _e6809 = select(-127f, _e6807, (_e6807 > -127f));
let _e6811 = select(128f, _e6809, (_e6809 < 128f));
let _e6818 = select(0i, select(select(i32(_e6811), i32(-2147483648), (_e6811 < -2147483600f)), 2147483647i, (_e6811 > 2147483500f)), (_e6811 == _e6811));
let _e6822 = (_e6818 - select(0i, 1i, (_e6811 < f32(_e6818))));
let _e6823 = f32(_e6822);
let _e6827 = ((_e6805 - (_e6823 * 0.6933594f)) - (_e6823 * -2.1219444e-4f));
let _e6849 = -((_e6748.member_2 * _e6744));
let _e6851 = select(-87f, _e6849, (_e6849 > -87f));
let _e6853 = select(88f, _e6851, (_e6851 < 88f));
let _e6855 = ((_e6853 * 1.442695f) + 0.5f);
let _e6857 = select(-127f, _e6855, (_e6855 > -127f));
let _e6859 = select(128f, _e6857, (_e6857 < 128f));
let _e6866 = select(0i, select(select(i32(_e6859), i32(-2147483648), (_e6859 < -2147483600f)), 2147483647i, (_e6859 > 2147483500f)), (_e6859 == _e6859));
let _e6870 = (_e6866 - select(0i, 1i, (_e6859 < f32(_e6866))));
let _e6871 = f32(_e6870);
let _e6875 = ((_e6853 - (_e6871 * 0.6933594f)) - (_e6871 * -2.1219444e-4f));
let _e6898 = (1f / 3f);
let _e6900 = (1f * ((1f + (_e6779 * (1f + (_e6779 * (0.5f + (_e6779 * (0.16666667f + (_e6779 * (0.041666668f + (_e6779 * (0.008333334f + (_e6779 * (0.001388889f + (_e6779 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6774 + 127i)) << bitcast<u32>(23i)))));
let _e6901 = (1f * ((1f + (_e6827 * (1f + (_e6827 * (0.5f + (_e6827 * (0.16666667f + (_e6827 * (0.041666668f + (_e6827 * (0.008333334f + (_e6827 * (0.001388889f + (_e6827 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6822 + 127i)) << bitcast<u32>(23i)))));
let _e6902 = (1f * ((1f + (_e6875 * (1f + (_e6875 * (0.5f + (_e6875 * (0.16666667f + (_e6875 * (0.041666668f + (_e6875 * (0.008333334f + (_e6875 * (0.001388889f + (_e6875 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6870 + 127i)) << bitcast<u32>(23i)))));
let _e6931 = type_27(_e6195.member, _e6195.member_1, _e6195.member_2, _e6195.member_3, _e6195.member_4, _e6195.member_5, vec3<f32>(_e6900, _e6901, _e6902), _e6195.member_7, _e6195.member_8, _e6195.member_9, _e6195.member_10, _e6195.member_11, _e6195.member_12, _e6195.member_13, _e6195.member_14, _e6195.member_15, _e6195.member_16, _e6195.member_17, _e6195.member_18, _e6195.member_19, _e6195.member_20, _e6195.member_21, _e6195.member_22, _e6195.member_23, _e6195.member_24, _e6195.member_25, _e6195.member_26, _e6195.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e5453.member_20) {
phi_12383_ = ((((1f + 1f) + 1f) * _e6898) - (((_e6900 + _e6901) + _e6902) * _e6898));
} else {
phi_12383_ = 0f;
}
let _e6941 = phi_12383_;
let _e6971 = type_27(_e6931.member, _e6931.member_1, _e6931.member_2, _e6931.member_3, _e6931.member_4, _e6931.member_5, _e6931.member_6, _e6931.member_7, _e6931.member_8, _e6931.member_9, _e6931.member_10, _e6931.member_11, _e6931.member_12, _e6931.member_13, _e6931.member_14, _e6931.member_15, _e6931.member_16, _e6931.member_17, _e6931.member_18, _e6931.member_19, _e6931.member_20, _e6931.member_21, _e6931.member_22, _e6931.member_23, _e6931.member_24, _e6931.member_25, (_e5453.member_26 + _e6941), _e6931.member_27);
if _e5723 {
phi_12410_ = type_27(_e6971.member, _e6971.member_1, _e6971.member_2, _e6971.member_3, _e6971.member_4, _e6971.member_5, _e6971.member_6, _e6971.member_7, _e1898, _e6971.member_9, _e6971.member_10, _e6971.member_11, _e6971.member_12, _e6971.member_13, _e6971.member_14, _e6971.member_15, _e6971.member_16, _e6971.member_17, _e6971.member_18, _e6971.member_19, _e6971.member_20, _e6971.member_21, _e6971.member_22, _e6971.member_23, _e6971.member_24, _e6971.member_25, _e6971.member_26, _e6971.member_27);
} else {
phi_12410_ = _e6971;
}
let _e7001 = phi_12410_;
phi_12411_ = _e7001;
}
let _e7031 = phi_12411_;
phi_12412_ = _e7031;
} else {
phi_12412_ = _e5177;
}
let _e7033 = phi_12412_;
phi_12413_ = type_27();
phi_12414_ = _e7033;
}
let _e7311 = phi_12413_;
let _e7313 = phi_12414_;
phi_12415_ = _e7311;
phi_12416_ = _e7313;
phi_12417_ = _e3132;
}
let _e9219 = phi_12415_;
let _e9221 = phi_12416_;
let _e9223 = phi_12417_;
if _e9223 {
phi_12421_ = _e9219;
} else {
phi_12421_ = _e9221;
}
let _e9225 = phi_12421_;
phi_12422_ = _e9225;
}
let _e9285 = phi_12422_;
phi_12424_ = _e9285;
phi_12425_ = select(false, _e1936, _e1979);
}
let _e10141 = phi_12424_;
let _e10143 = phi_12425_;
phi_3217_ = _e10141;
phi_3220_ = (_e1934 + 1i);
phi_3222_ = _e10143;
} else {
phi_3217_ = type_27();
phi_3220_ = i32();
phi_3222_ = bool();
}
let _e10145 = phi_3217_;
let _e10147 = phi_3220_;
let _e10149 = phi_3222_;
continue;
continuing {
phi_3216_ = _e10145;
phi_3219_ = _e10147;
phi_3221_ = _e10149;
break if !(_e1940);
}
}
let _e10152 = local_26;
let _e10156 = local_27;
let _e10160 = local_28;
let _e10164 = local_29;
let _e10168 = local_30;
let _e10172 = local_31;
let _e10176 = local_32;
let _e10180 = local_33;
let _e10184 = local_34;
let _e10188 = local_35;
let _e10192 = local_36;
let _e10196 = local_37;
let _e10200 = local_38;
let _e10204 = local_39;
let _e10208 = local_40;
let _e10212 = local_41;
let _e10216 = local_42;
let _e10220 = local_43;
let _e10224 = local_44;
let _e10228 = local_45;
let _e10232 = local_46;
let _e10236 = local_47;
let _e10240 = local_48;
let _e10244 = local_49;
let _e10248 = local_50;
let _e10251 = local_51;
let _e10255 = local_52;
let _e10259 = local_53;
let _e10262 = local_54;
let _e10265 = local_55;
let _e10269 = local_56;
let _e10273 = local_57;
let _e10277 = local_58;
let _e10281 = local_59;
let _e10285 = local_60;
let _e10289 = local_61;
let _e10293 = local_62;
let _e10296 = local_63;
let _e10299 = local_64;
let _e10302 = local_65;
let _e10305 = local_66;
global_4.member[_e163] = _e10152.member.x;
global_4.member[_e175] = _e10156.member.y;
global_4.member[_e186] = _e10160.member.z;
global_4.member[_e197] = _e10164.member_1.x;
global_4.member[_e208] = _e10168.member_1.y;
global_4.member[_e219] = _e10172.member_1.z;
global_4.member[_e230] = _e10176.member_2.x;
global_4.member[_e241] = _e10180.member_2.y;
global_4.member[_e252] = _e10184.member_2.z;
global_4.member[_e263] = _e10188.member_3.x;
global_4.member[_e274] = _e10192.member_3.y;
global_4.member[_e285] = _e10196.member_3.z;
global_4.member[_e296] = _e10200.member_4.x;
global_4.member[_e307] = _e10204.member_4.y;
global_4.member[_e318] = _e10208.member_4.z;
global_4.member[_e329] = _e10212.member_5.x;
global_4.member[_e340] = _e10216.member_5.y;
global_4.member[_e351] = _e10220.member_5.z;
global_4.member[_e362] = _e10224.member_6.x;
global_4.member[_e373] = _e10228.member_6.y;
global_4.member[_e384] = _e10232.member_6.z;
global_4.member[_e395] = f32(_e10236.member_7);
global_4.member[_e406] = f32(_e10240.member_8);
global_4.member[_e417] = f32(_e10244.member_9);
global_4.member[_e428] = _e10248.member_10;
global_4.member[_e439] = f32(_e10251.member_11);
global_4.member[_e450] = f32(_e10255.member_12);
global_4.member[_e461] = _e10259.member_13;
global_4.member[_e472] = _e10262.member_14;
let _e10368 = local_67;
global_4.member[_e483] = _e10368;
global_4.member[_e494] = f32(_e10265.member_16);
global_4.member[_e505] = f32(_e10269.member_17);
global_4.member[_e516] = f32(_e10273.member_18);
global_4.member[_e527] = f32(_e10277.member_19);
global_4.member[_e538] = f32(_e10281.member_20);
global_4.member[_e549] = f32(_e10285.member_21);
global_4.member[_e560] = f32(_e10289.member_22);
global_4.member[_e571] = _e10293.member_23;
global_4.member[_e582] = _e10296.member_24;
global_4.member[_e593] = _e10299.member_25;
global_4.member[_e604] = _e10302.member_26;
global_4.member[_e615] = _e10305.member_27;
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
