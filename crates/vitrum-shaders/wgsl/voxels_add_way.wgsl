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
member: type_2,
member_1: u32,
member_2: type_5,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_5,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: u32,
member_12: u32,
member_13: u32,
}
struct type_14 {
member: u32,
member_1: u32,
}
struct type_15 {
member: type_14,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_16 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_17 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_14,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_14,
member_18: type_15,
member_19: type_5,
member_20: type_16,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_18 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: type_2,
member_5: u32,
member_6: type_4,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: type_5,
member_11: f32,
member_12: f32,
member_13: f32,
member_14: type_5,
member_15: type_5,
member_16: type_6,
member_17: type_5,
member_18: type_9,
member_19: type_11,
member_20: type_12,
member_21: type_13,
member_22: type_17,
}
struct type_19 {
member: type_18,
}
struct type_21 {
member: array<f32>,
}
struct type_26 {
member: array<u32>,
}
struct type_27 {
member: vec3<f32>,
member_1: vec3<f32>,
}
struct type_28 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: f32,
member_5: bool,
member_6: bool,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_19;
@group(0) @binding(1)
var<storage> global_2: type_21;
@group(0) @binding(2)
var<storage> global_3: type_21;
@group(0) @binding(3)
var<storage> global_4: type_21;
@group(0) @binding(4)
var<storage> global_5: type_21;
@group(0) @binding(5)
var<storage> global_6: type_26;
@group(0) @binding(6)
var<storage, read_write> global_7: type_21;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var local_16: i32;
var local_17: i32;
var local_18: i32;
var local_19: i32;
var local_20: i32;
var local_21: i32;
var local_22: i32;
var local_23: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var local_31: i32;
var local_32: i32;
var local_33: i32;
var local_34: i32;
var local_35: i32;
var local_36: i32;
var phi_2928_: vec3<f32>;
var phi_3530_: i32;
var phi_3533_: i32;
var phi_3535_: i32;
var phi_3537_: i32;
var phi_3552_: i32;
var phi_3558_: i32;
var phi_3531_: i32;
var phi_3534_: i32;
var phi_3536_: i32;
var phi_3538_: i32;
var local_37: i32;
var local_38: i32;
var local_39: i32;
var phi_3633_: i32;
var local_40: i32;
var local_41: i32;
var phi_3639_: i32;
var local_42: i32;
var phi_3646_: i32;
var local_43: i32;
var local_44: i32;
var phi_3652_: i32;
var local_45: i32;
var local_46: i32;
var phi_3663_: i32;
var local_47: i32;
var local_48: i32;
var phi_3675_: i32;
var local_49: i32;
var local_50: i32;
var local_51: i32;
var local_52: i32;
var phi_3911_: i32;
var phi_3914_: i32;
var phi_3916_: i32;
var phi_3918_: i32;
var phi_3933_: i32;
var phi_3939_: i32;
var phi_3912_: i32;
var phi_3915_: i32;
var phi_3917_: i32;
var phi_3919_: i32;
var local_53: i32;
var local_54: i32;
var local_55: i32;
var phi_4014_: i32;
var local_56: i32;
var local_57: i32;
var phi_4020_: i32;
var local_58: i32;
var phi_4027_: i32;
var local_59: i32;
var local_60: i32;
var phi_4033_: i32;
var local_61: i32;
var local_62: i32;
var phi_4044_: i32;
var local_63: i32;
var local_64: i32;
var phi_4056_: i32;
var local_65: i32;
var local_66: i32;
var local_67: i32;
var local_68: i32;
var phi_4311_: vec3<f32>;
var phi_4312_: vec3<f32>;
var phi_4313_: vec3<f32>;
var phi_5175_: type_28;
var phi_5749_: vec3<f32>;
var phi_5752_: vec3<f32>;
var phi_5765_: type_27;
var phi_6108_: i32;
var phi_6111_: i32;
var phi_6113_: f32;
var phi_6115_: f32;
var phi_6191_: i32;
var phi_6340_: i32;
var phi_6343_: f32;
var phi_6345_: f32;
var phi_6341_: i32;
var phi_6344_: f32;
var phi_6346_: f32;
var local_69: f32;
var phi_6466_: f32;
var phi_6467_: f32;
var phi_6473_: i32;
var phi_6109_: i32;
var phi_6112_: i32;
var phi_6114_: f32;
var phi_6116_: f32;
var local_70: f32;
var local_71: f32;
var local_72: f32;
var local_73: f32;
var phi_6517_: f32;
var phi_6635_: f32;
var phi_6638_: vec3<f32>;
var phi_6640_: i32;
var phi_6655_: i32;
var phi_6658_: f32;
var phi_6660_: vec3<f32>;
var phi_7049_: vec3<f32>;
var phi_7059_: vec3<f32>;
var phi_6656_: i32;
var phi_6659_: f32;
var phi_6661_: vec3<f32>;
var phi_6636_: f32;
var phi_6639_: vec3<f32>;
var phi_6641_: i32;
var local_74: f32;
var local_75: f32;
var local_76: vec3<f32>;
var local_77: vec3<f32>;
var local_78: vec3<f32>;
var phi_7420_: u32;
var phi_7756_: f32;
var phi_7788_: vec3<f32>;
var phi_7960_: i32;
var phi_7963_: i32;
var phi_7965_: f32;
var phi_7967_: f32;
var phi_8043_: i32;
var phi_8192_: i32;
var phi_8195_: f32;
var phi_8197_: f32;
var phi_8193_: i32;
var phi_8196_: f32;
var phi_8198_: f32;
var local_79: f32;
var phi_8318_: f32;
var phi_8319_: f32;
var phi_8325_: i32;
var phi_7961_: i32;
var phi_7964_: i32;
var phi_7966_: f32;
var phi_7968_: f32;
var local_80: f32;
var local_81: f32;
var local_82: f32;
var local_83: f32;
var phi_8369_: f32;
var phi_8487_: f32;
var phi_8490_: vec3<f32>;
var phi_8492_: i32;
var phi_8507_: i32;
var phi_8510_: f32;
var phi_8512_: vec3<f32>;
var phi_8901_: vec3<f32>;
var phi_8911_: vec3<f32>;
var phi_8508_: i32;
var phi_8511_: f32;
var phi_8513_: vec3<f32>;
var phi_8488_: f32;
var phi_8491_: vec3<f32>;
var phi_8493_: i32;
var local_84: f32;
var local_85: f32;
var local_86: vec3<f32>;
var local_87: vec3<f32>;
var local_88: vec3<f32>;
var phi_8962_: vec3<f32>;
var phi_9159_: vec3<f32>;
var local_89: f32;
var local_90: vec3<f32>;
var local_91: f32;
var local_92: vec3<f32>;
let _e142 = global;
let _e148 = arrayLength((&global_3.member));
let _e154 = arrayLength((&global_6.member));
let _e159 = global_1.member.member;
if (_e142.x < _e159.member) {
if (_e142.y < _e159.member_1) {
let _e166 = (_e159.member * _e159.member_1);
let _e168 = ((_e142.y * _e159.member) + _e142.x);
let _e169 = bitcast<i32>(_e168);
let _e171 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e173 = select(_e171, _e169, (_e169 < _e171));
let _e179 = global_7.member[bitcast<u32>(select(0i, _e173, (_e173 > 0i)))];
let _e180 = (_e166 + _e168);
let _e181 = bitcast<i32>(_e180);
let _e183 = select(_e171, _e181, (_e181 < _e171));
let _e189 = global_7.member[bitcast<u32>(select(0i, _e183, (_e183 > 0i)))];
let _e191 = ((2u * _e166) + _e168);
let _e192 = bitcast<i32>(_e191);
let _e194 = select(_e171, _e192, (_e192 < _e171));
let _e200 = global_7.member[bitcast<u32>(select(0i, _e194, (_e194 > 0i)))];
let _e202 = ((3u * _e166) + _e168);
let _e203 = bitcast<i32>(_e202);
let _e205 = select(_e171, _e203, (_e203 < _e171));
let _e211 = global_7.member[bitcast<u32>(select(0i, _e205, (_e205 > 0i)))];
let _e213 = ((4u * _e166) + _e168);
let _e214 = bitcast<i32>(_e213);
let _e216 = select(_e171, _e214, (_e214 < _e171));
let _e222 = global_7.member[bitcast<u32>(select(0i, _e216, (_e216 > 0i)))];
let _e224 = ((5u * _e166) + _e168);
let _e225 = bitcast<i32>(_e224);
let _e227 = select(_e171, _e225, (_e225 < _e171));
let _e233 = global_7.member[bitcast<u32>(select(0i, _e227, (_e227 > 0i)))];
let _e235 = ((6u * _e166) + _e168);
let _e236 = bitcast<i32>(_e235);
let _e238 = select(_e171, _e236, (_e236 < _e171));
let _e244 = global_7.member[bitcast<u32>(select(0i, _e238, (_e238 > 0i)))];
let _e246 = ((7u * _e166) + _e168);
let _e247 = bitcast<i32>(_e246);
let _e249 = select(_e171, _e247, (_e247 < _e171));
let _e255 = global_7.member[bitcast<u32>(select(0i, _e249, (_e249 > 0i)))];
let _e257 = ((8u * _e166) + _e168);
let _e258 = bitcast<i32>(_e257);
let _e260 = select(_e171, _e258, (_e258 < _e171));
let _e266 = global_7.member[bitcast<u32>(select(0i, _e260, (_e260 > 0i)))];
let _e268 = ((9u * _e166) + _e168);
let _e269 = bitcast<i32>(_e268);
let _e271 = select(_e171, _e269, (_e269 < _e171));
let _e277 = global_7.member[bitcast<u32>(select(0i, _e271, (_e271 > 0i)))];
let _e279 = ((10u * _e166) + _e168);
let _e280 = bitcast<i32>(_e279);
let _e282 = select(_e171, _e280, (_e280 < _e171));
let _e288 = global_7.member[bitcast<u32>(select(0i, _e282, (_e282 > 0i)))];
let _e290 = ((11u * _e166) + _e168);
let _e291 = bitcast<i32>(_e290);
let _e293 = select(_e171, _e291, (_e291 < _e171));
let _e299 = global_7.member[bitcast<u32>(select(0i, _e293, (_e293 > 0i)))];
let _e301 = ((12u * _e166) + _e168);
let _e302 = bitcast<i32>(_e301);
let _e304 = select(_e171, _e302, (_e302 < _e171));
let _e310 = global_7.member[bitcast<u32>(select(0i, _e304, (_e304 > 0i)))];
let _e312 = ((13u * _e166) + _e168);
let _e313 = bitcast<i32>(_e312);
let _e315 = select(_e171, _e313, (_e313 < _e171));
let _e321 = global_7.member[bitcast<u32>(select(0i, _e315, (_e315 > 0i)))];
let _e323 = ((14u * _e166) + _e168);
let _e324 = bitcast<i32>(_e323);
let _e326 = select(_e171, _e324, (_e324 < _e171));
let _e332 = global_7.member[bitcast<u32>(select(0i, _e326, (_e326 > 0i)))];
let _e334 = ((15u * _e166) + _e168);
let _e335 = bitcast<i32>(_e334);
let _e337 = select(_e171, _e335, (_e335 < _e171));
let _e343 = global_7.member[bitcast<u32>(select(0i, _e337, (_e337 > 0i)))];
let _e345 = ((16u * _e166) + _e168);
let _e346 = bitcast<i32>(_e345);
let _e348 = select(_e171, _e346, (_e346 < _e171));
let _e354 = global_7.member[bitcast<u32>(select(0i, _e348, (_e348 > 0i)))];
let _e356 = ((17u * _e166) + _e168);
let _e357 = bitcast<i32>(_e356);
let _e359 = select(_e171, _e357, (_e357 < _e171));
let _e365 = global_7.member[bitcast<u32>(select(0i, _e359, (_e359 > 0i)))];
let _e369 = global_1.member.member.member;
let _e372 = bitcast<i32>(((_e142.y * _e369) + _e142.x));
local_35 = _e372;
let _e376 = global_1.member.member.member_1;
let _e378 = bitcast<i32>((_e369 * _e376));
local_36 = _e378;
let _e379 = local_36;
let _e381 = local_35;
let _e382 = ((6i * _e379) + _e381);
let _e384 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e386 = select(_e384, _e382, (_e382 < _e384));
let _e391 = global_2.member[bitcast<u32>(select(0i, _e386, (_e386 > 0i)))];
let _e392 = local_36;
let _e394 = local_35;
let _e395 = ((7i * _e392) + _e394);
let _e397 = select(_e384, _e395, (_e395 < _e384));
let _e402 = global_2.member[bitcast<u32>(select(0i, _e397, (_e397 > 0i)))];
let _e403 = local_36;
let _e405 = local_35;
let _e406 = ((8i * _e403) + _e405);
let _e408 = select(_e384, _e406, (_e406 < _e384));
let _e413 = global_2.member[bitcast<u32>(select(0i, _e408, (_e408 > 0i)))];
local_33 = _e372;
local_34 = _e378;
let _e416 = local_34;
let _e418 = local_33;
let _e419 = ((22i * _e416) + _e418);
let _e421 = select(_e384, _e419, (_e419 < _e384));
let _e426 = global_2.member[bitcast<u32>(select(0i, _e421, (_e421 > 0i)))];
let _e427 = local_34;
let _e429 = local_33;
let _e430 = ((23i * _e427) + _e429);
let _e432 = select(_e384, _e430, (_e430 < _e384));
let _e437 = global_2.member[bitcast<u32>(select(0i, _e432, (_e432 > 0i)))];
let _e438 = local_34;
let _e440 = local_33;
let _e441 = ((24i * _e438) + _e440);
let _e443 = select(_e384, _e441, (_e441 < _e384));
let _e448 = global_2.member[bitcast<u32>(select(0i, _e443, (_e443 > 0i)))];
if (select(0u, 3u, ((((_e391 + _e402) + _e413) + ((_e426 + _e437) + _e448)) > 0f)) > 1u) {
local_31 = _e372;
local_32 = _e378;
let _e456 = bitcast<i32>(_e142.x);
let _e457 = bitcast<i32>(_e142.y);
let _e458 = local_32;
let _e460 = local_31;
let _e461 = ((18i * _e458) + _e460);
let _e463 = select(_e384, _e461, (_e461 < _e384));
let _e468 = global_2.member[bitcast<u32>(select(0i, _e463, (_e463 > 0i)))];
let _e469 = local_32;
let _e471 = local_31;
let _e472 = ((16i * _e469) + _e471);
let _e474 = select(_e384, _e472, (_e472 < _e384));
let _e479 = global_2.member[bitcast<u32>(select(0i, _e474, (_e474 > 0i)))];
let _e480 = (_e456 - 1i);
let _e481 = bitcast<i32>(_e369);
let _e482 = bitcast<i32>(_e376);
local_28 = _e481;
local_29 = _e482;
let _e484 = local_28;
let _e487 = (_e457 >= 0i);
let _e489 = local_29;
let _e491 = ((((_e480 >= 0i) && (_e480 < _e484)) && _e487) && (_e457 < _e489));
if _e491 {
let _e492 = local_28;
local_30 = ((_e457 * _e492) + _e480);
} else {
local_30 = 0i;
}
let _e495 = local_28;
let _e496 = local_29;
let _e499 = local_30;
let _e500 = ((18i * (_e495 * _e496)) + _e499);
let _e502 = select(_e384, _e500, (_e500 < _e384));
let _e507 = global_2.member[bitcast<u32>(select(0i, _e502, (_e502 > 0i)))];
let _e510 = local_28;
let _e511 = local_29;
let _e514 = local_30;
let _e515 = ((16i * (_e510 * _e511)) + _e514);
let _e517 = select(_e384, _e515, (_e515 < _e384));
let _e522 = global_2.member[bitcast<u32>(select(0i, _e517, (_e517 > 0i)))];
let _e524 = ((_e491 && (_e507 == _e468)) && (_e522 == _e479));
let _e525 = local_28;
let _e526 = local_29;
let _e529 = local_30;
let _e530 = ((18i * (_e525 * _e526)) + _e529);
let _e532 = select(_e384, _e530, (_e530 < _e384));
let _e537 = global_2.member[bitcast<u32>(select(0i, _e532, (_e532 > 0i)))];
let _e540 = local_28;
let _e541 = local_29;
let _e544 = local_30;
let _e545 = ((16i * (_e540 * _e541)) + _e544);
let _e547 = select(_e384, _e545, (_e545 < _e384));
let _e552 = global_2.member[bitcast<u32>(select(0i, _e547, (_e547 > 0i)))];
let _e555 = local_30;
local_26 = _e555;
local_27 = _e378;
let _e556 = local_27;
let _e558 = local_26;
let _e559 = ((3i * _e556) + _e558);
let _e561 = select(_e384, _e559, (_e559 < _e384));
let _e566 = global_2.member[bitcast<u32>(select(0i, _e561, (_e561 > 0i)))];
let _e567 = local_27;
let _e569 = local_26;
let _e570 = ((4i * _e567) + _e569);
let _e572 = select(_e384, _e570, (_e570 < _e384));
let _e577 = global_2.member[bitcast<u32>(select(0i, _e572, (_e572 > 0i)))];
let _e578 = local_27;
let _e580 = local_26;
let _e581 = ((5i * _e578) + _e580);
let _e583 = select(_e384, _e581, (_e581 < _e384));
let _e588 = global_2.member[bitcast<u32>(select(0i, _e583, (_e583 > 0i)))];
let _e589 = (_e456 + 1i);
local_23 = _e481;
local_24 = _e482;
let _e591 = local_23;
let _e595 = local_24;
let _e597 = ((((_e589 >= 0i) && (_e589 < _e591)) && _e487) && (_e457 < _e595));
if _e597 {
let _e598 = local_23;
local_25 = ((_e457 * _e598) + _e589);
} else {
local_25 = 0i;
}
let _e601 = local_23;
let _e602 = local_24;
let _e605 = local_25;
let _e606 = ((18i * (_e601 * _e602)) + _e605);
let _e608 = select(_e384, _e606, (_e606 < _e384));
let _e613 = global_2.member[bitcast<u32>(select(0i, _e608, (_e608 > 0i)))];
let _e616 = local_23;
let _e617 = local_24;
let _e620 = local_25;
let _e621 = ((16i * (_e616 * _e617)) + _e620);
let _e623 = select(_e384, _e621, (_e621 < _e384));
let _e628 = global_2.member[bitcast<u32>(select(0i, _e623, (_e623 > 0i)))];
let _e630 = ((_e597 && (_e613 == _e468)) && (_e628 == _e479));
let _e631 = local_23;
let _e632 = local_24;
let _e635 = local_25;
let _e636 = ((18i * (_e631 * _e632)) + _e635);
let _e638 = select(_e384, _e636, (_e636 < _e384));
let _e643 = global_2.member[bitcast<u32>(select(0i, _e638, (_e638 > 0i)))];
let _e646 = local_23;
let _e647 = local_24;
let _e650 = local_25;
let _e651 = ((16i * (_e646 * _e647)) + _e650);
let _e653 = select(_e384, _e651, (_e651 < _e384));
let _e658 = global_2.member[bitcast<u32>(select(0i, _e653, (_e653 > 0i)))];
let _e661 = local_25;
local_21 = _e661;
local_22 = _e378;
let _e662 = local_22;
let _e664 = local_21;
let _e665 = ((3i * _e662) + _e664);
let _e667 = select(_e384, _e665, (_e665 < _e384));
let _e672 = global_2.member[bitcast<u32>(select(0i, _e667, (_e667 > 0i)))];
let _e673 = local_22;
let _e675 = local_21;
let _e676 = ((4i * _e673) + _e675);
let _e678 = select(_e384, _e676, (_e676 < _e384));
let _e683 = global_2.member[bitcast<u32>(select(0i, _e678, (_e678 > 0i)))];
let _e684 = local_22;
let _e686 = local_21;
let _e687 = ((5i * _e684) + _e686);
let _e689 = select(_e384, _e687, (_e687 < _e384));
let _e694 = global_2.member[bitcast<u32>(select(0i, _e689, (_e689 > 0i)))];
let _e695 = (_e457 - 1i);
local_18 = _e481;
local_19 = _e482;
let _e696 = (_e456 >= 0i);
let _e697 = local_18;
let _e702 = local_19;
let _e704 = (((_e696 && (_e456 < _e697)) && (_e695 >= 0i)) && (_e695 < _e702));
if _e704 {
let _e705 = local_18;
local_20 = ((_e695 * _e705) + _e456);
} else {
local_20 = 0i;
}
let _e708 = local_18;
let _e709 = local_19;
let _e712 = local_20;
let _e713 = ((18i * (_e708 * _e709)) + _e712);
let _e715 = select(_e384, _e713, (_e713 < _e384));
let _e720 = global_2.member[bitcast<u32>(select(0i, _e715, (_e715 > 0i)))];
let _e723 = local_18;
let _e724 = local_19;
let _e727 = local_20;
let _e728 = ((16i * (_e723 * _e724)) + _e727);
let _e730 = select(_e384, _e728, (_e728 < _e384));
let _e735 = global_2.member[bitcast<u32>(select(0i, _e730, (_e730 > 0i)))];
let _e737 = ((_e704 && (_e720 == _e468)) && (_e735 == _e479));
let _e738 = local_18;
let _e739 = local_19;
let _e742 = local_20;
let _e743 = ((18i * (_e738 * _e739)) + _e742);
let _e745 = select(_e384, _e743, (_e743 < _e384));
let _e750 = global_2.member[bitcast<u32>(select(0i, _e745, (_e745 > 0i)))];
let _e753 = local_18;
let _e754 = local_19;
let _e757 = local_20;
let _e758 = ((16i * (_e753 * _e754)) + _e757);
let _e760 = select(_e384, _e758, (_e758 < _e384));
let _e765 = global_2.member[bitcast<u32>(select(0i, _e760, (_e760 > 0i)))];
let _e768 = local_20;
local_16 = _e768;
local_17 = _e378;
let _e769 = local_17;
let _e771 = local_16;
let _e772 = ((3i * _e769) + _e771);
let _e774 = select(_e384, _e772, (_e772 < _e384));
let _e779 = global_2.member[bitcast<u32>(select(0i, _e774, (_e774 > 0i)))];
let _e780 = local_17;
let _e782 = local_16;
let _e783 = ((4i * _e780) + _e782);
let _e785 = select(_e384, _e783, (_e783 < _e384));
let _e790 = global_2.member[bitcast<u32>(select(0i, _e785, (_e785 > 0i)))];
let _e791 = local_17;
let _e793 = local_16;
let _e794 = ((5i * _e791) + _e793);
let _e796 = select(_e384, _e794, (_e794 < _e384));
let _e801 = global_2.member[bitcast<u32>(select(0i, _e796, (_e796 > 0i)))];
let _e802 = (_e457 + 1i);
local_13 = _e481;
local_14 = _e482;
let _e803 = local_13;
let _e808 = local_14;
let _e810 = (((_e696 && (_e456 < _e803)) && (_e802 >= 0i)) && (_e802 < _e808));
if _e810 {
let _e811 = local_13;
local_15 = ((_e802 * _e811) + _e456);
} else {
local_15 = 0i;
}
let _e814 = local_13;
let _e815 = local_14;
let _e818 = local_15;
let _e819 = ((18i * (_e814 * _e815)) + _e818);
let _e821 = select(_e384, _e819, (_e819 < _e384));
let _e826 = global_2.member[bitcast<u32>(select(0i, _e821, (_e821 > 0i)))];
let _e829 = local_13;
let _e830 = local_14;
let _e833 = local_15;
let _e834 = ((16i * (_e829 * _e830)) + _e833);
let _e836 = select(_e384, _e834, (_e834 < _e384));
let _e841 = global_2.member[bitcast<u32>(select(0i, _e836, (_e836 > 0i)))];
let _e843 = ((_e810 && (_e826 == _e468)) && (_e841 == _e479));
let _e844 = local_13;
let _e845 = local_14;
let _e848 = local_15;
let _e849 = ((18i * (_e844 * _e845)) + _e848);
let _e851 = select(_e384, _e849, (_e849 < _e384));
let _e856 = global_2.member[bitcast<u32>(select(0i, _e851, (_e851 > 0i)))];
let _e859 = local_13;
let _e860 = local_14;
let _e863 = local_15;
let _e864 = ((16i * (_e859 * _e860)) + _e863);
let _e866 = select(_e384, _e864, (_e864 < _e384));
let _e871 = global_2.member[bitcast<u32>(select(0i, _e866, (_e866 > 0i)))];
let _e874 = local_15;
local_11 = _e874;
local_12 = _e378;
let _e875 = local_12;
let _e877 = local_11;
let _e878 = ((3i * _e875) + _e877);
let _e880 = select(_e384, _e878, (_e878 < _e384));
let _e885 = global_2.member[bitcast<u32>(select(0i, _e880, (_e880 > 0i)))];
let _e886 = local_12;
let _e888 = local_11;
let _e889 = ((4i * _e886) + _e888);
let _e891 = select(_e384, _e889, (_e889 < _e384));
let _e896 = global_2.member[bitcast<u32>(select(0i, _e891, (_e891 > 0i)))];
let _e897 = local_12;
let _e899 = local_11;
let _e900 = ((5i * _e897) + _e899);
let _e902 = select(_e384, _e900, (_e900 < _e384));
let _e907 = global_2.member[bitcast<u32>(select(0i, _e902, (_e902 > 0i)))];
let _e908 = f32(_e481);
let _e918 = global_1.member.member_6.member;
let _e919 = (((((f32(_e589) + 0.5f) / _e908) * 2f) - 1f) * _e918);
let _e928 = global_1.member.member_6.member_1;
let _e929 = ((1f - (((f32(_e457) + 0.5f) / f32(_e482)) * 2f)) * _e928);
let _e932 = global_1.member.member_7;
let _e941 = global_1.member.member_8;
let _e945 = (_e941.member * _e929);
let _e946 = (_e941.member_1 * _e929);
let _e947 = (_e941.member_2 * _e929);
let _e954 = global_1.member.member_6.member_3;
let _e956 = select(1f, 0f, (_e954 != 0u));
let _e959 = global_1.member.member_9;
let _e966 = (_e959.member + (((_e932.member * _e919) + _e945) * _e956));
let _e967 = (_e959.member_1 + (((_e932.member_1 * _e919) + _e946) * _e956));
let _e968 = (_e959.member_2 + (((_e932.member_2 * _e919) + _e947) * _e956));
let _e973 = (((_e966 * _e966) + (_e967 * _e967)) + (_e968 * _e968));
let _e976 = sqrt(select(0f, _e973, (_e973 > 0f)));
let _e979 = (1f / select(1e-20f, _e976, (_e976 > 1e-20f)));
let _e988 = (((((f32(_e456) + 0.5f) / _e908) * 2f) - 1f) * _e918);
let _e998 = (_e959.member + (((_e932.member * _e988) + _e945) * _e956));
let _e999 = (_e959.member_1 + (((_e932.member_1 * _e988) + _e946) * _e956));
let _e1000 = (_e959.member_2 + (((_e932.member_2 * _e988) + _e947) * _e956));
let _e1005 = (((_e998 * _e998) + (_e999 * _e999)) + (_e1000 * _e1000));
let _e1008 = sqrt(select(0f, _e1005, (_e1005 > 0f)));
let _e1011 = (1f / select(1e-20f, _e1008, (_e1008 > 1e-20f)));
let _e1015 = ((_e966 * _e979) - (_e998 * _e1011));
let _e1016 = ((_e967 * _e979) - (_e999 * _e1011));
let _e1017 = ((_e968 * _e979) - (_e1000 * _e1011));
let _e1022 = (((_e1015 * _e1015) + (_e1016 * _e1016)) + (_e1017 * _e1017));
let _e1025 = sqrt(select(0f, _e1022, (_e1022 > 0f)));
let _e1026 = local_31;
local_7 = _e1026;
local_8 = _e378;
let _e1027 = local_7;
local_9 = _e1027;
local_10 = _e378;
let _e1028 = local_10;
let _e1030 = local_9;
let _e1031 = ((3i * _e1028) + _e1030);
let _e1033 = select(_e384, _e1031, (_e1031 < _e384));
let _e1038 = global_2.member[bitcast<u32>(select(0i, _e1033, (_e1033 > 0i)))];
let _e1039 = local_10;
let _e1041 = local_9;
let _e1042 = ((4i * _e1039) + _e1041);
let _e1044 = select(_e384, _e1042, (_e1042 < _e384));
let _e1049 = global_2.member[bitcast<u32>(select(0i, _e1044, (_e1044 > 0i)))];
let _e1050 = local_10;
let _e1052 = local_9;
let _e1053 = ((5i * _e1050) + _e1052);
let _e1055 = select(_e384, _e1053, (_e1053 < _e384));
let _e1060 = global_2.member[bitcast<u32>(select(0i, _e1055, (_e1055 > 0i)))];
let _e1061 = local_8;
let _e1063 = local_7;
let _e1064 = ((18i * _e1061) + _e1063);
let _e1066 = select(_e384, _e1064, (_e1064 < _e384));
let _e1071 = global_2.member[bitcast<u32>(select(0i, _e1066, (_e1066 > 0i)))];
let _e1073 = (_e1038 - _e566);
let _e1074 = (_e1049 - _e577);
let _e1075 = (_e1060 - _e588);
let _e1080 = (((_e1073 * _e1073) + (_e1074 * _e1074)) + (_e1075 * _e1075));
let _e1083 = sqrt(select(0f, _e1080, (_e1080 > 0f)));
let _e1084 = (_e672 - _e1038);
let _e1085 = (_e683 - _e1049);
let _e1086 = (_e694 - _e1060);
let _e1091 = (((_e1084 * _e1084) + (_e1085 * _e1085)) + (_e1086 * _e1086));
let _e1094 = sqrt(select(0f, _e1091, (_e1091 > 0f)));
let _e1100 = ((select(0f, _e1083, _e524) + select(0f, _e1094, _e630)) * select(1f, 0.5f, (_e524 && _e630)));
let _e1102 = select(4f, _e1083, ((_e491 && (_e537 > 0f)) && (_e552 == 1f)));
let _e1103 = select(4f, _e1094, ((_e597 && (_e643 > 0f)) && (_e658 == 1f)));
let _e1105 = select(_e1103, _e1102, (_e1102 < _e1103));
let _e1106 = (_e1038 - _e779);
let _e1107 = (_e1049 - _e790);
let _e1108 = (_e1060 - _e801);
let _e1113 = (((_e1106 * _e1106) + (_e1107 * _e1107)) + (_e1108 * _e1108));
let _e1116 = sqrt(select(0f, _e1113, (_e1113 > 0f)));
let _e1117 = (_e885 - _e1038);
let _e1118 = (_e896 - _e1049);
let _e1119 = (_e907 - _e1060);
let _e1124 = (((_e1117 * _e1117) + (_e1118 * _e1118)) + (_e1119 * _e1119));
let _e1127 = sqrt(select(0f, _e1124, (_e1124 > 0f)));
let _e1133 = ((select(0f, _e1116, _e737) + select(0f, _e1127, _e843)) * select(1f, 0.5f, (_e737 && _e843)));
let _e1135 = select(4f, _e1116, ((_e704 && (_e750 > 0f)) && (_e765 == 1f)));
let _e1136 = select(4f, _e1127, ((_e810 && (_e856 > 0f)) && (_e871 == 1f)));
let _e1138 = select(_e1136, _e1135, (_e1135 < _e1136));
let _e1142 = select(_e1138, _e1105, (_e1105 < _e1138));
let _e1149 = select(_e1025, select(select(_e1025, select(_e1025, _e1142, (_e1142 > _e1025)), (_e1142 < 4f)), select(_e1133, _e1100, (_e1100 > _e1133)), ((_e524 || _e630) || (_e737 || _e843))), (_e1071 > 0f));
let _e1153 = global_1.member.member_16.member_4;
let _e1161 = (((_e1153.member * _e1038) + (_e1153.member_1 * _e1049)) + (_e1153.member_2 * _e1060));
let _e1165 = global_1.member.member_16.member_5;
let _e1173 = (((_e1165.member * _e1038) + (_e1165.member_1 * _e1049)) + (_e1165.member_2 * _e1060));
let _e1177 = global_1.member.member_16.member_6;
let _e1185 = (((_e1177.member * _e1038) + (_e1177.member_1 * _e1049)) + (_e1177.member_2 * _e1060));
let _e1189 = global_1.member.member_16.member;
let _e1193 = global_1.member.member_16.member_7;
let _e1197 = vec3<f32>(_e1193.member, _e1193.member_1, _e1193.member_2);
let _e1201 = global_1.member.member_16.member_8;
if (_e1189 == 0u) {
phi_4313_ = _e1197;
} else {
if (_e1189 == 1u) {
let _e1208 = select(-1f, _e1185, (_e1185 > -1f));
let _e1210 = select(1f, _e1208, (_e1208 < 1f));
if (_e1210 > 0f) {
phi_2928_ = _e1197;
} else {
let _e1215 = global_1.member.member_16.member_9;
phi_2928_ = vec3<f32>(_e1215.member, _e1215.member_1, _e1215.member_2);
}
let _e1221 = phi_2928_;
let _e1230 = bitcast<f32>((bitcast<u32>(_e1210) & 2147483647u));
let _e1233 = sqrt(select(0f, _e1230, (_e1230 > 0f)));
phi_4312_ = vec3<f32>((_e1201.member + ((_e1221.x - _e1201.member) * _e1233)), (_e1201.member_1 + ((_e1221.y - _e1201.member_1) * _e1233)), (_e1201.member_2 + ((_e1221.z - _e1201.member_2) * _e1233)));
} else {
if (_e1189 == 2u) {
let _e1245 = global_1.member.member_16.member_10;
let _e1246 = (_e1149 / _e1245);
let _e1248 = select(1e-4f, _e1246, (_e1246 > 1e-4f));
let _e1251 = bitcast<f32>((bitcast<u32>(_e1161) & 2147483647u));
let _e1254 = bitcast<f32>((bitcast<u32>(_e1173) & 2147483647u));
let _e1258 = select(_e1254, _e1251, (_e1251 > _e1254));
let _e1261 = (select(_e1254, _e1251, (_e1251 < _e1254)) / select(1.1754944e-38f, _e1258, (_e1258 > 1.1754944e-38f)));
let _e1262 = (_e1261 > 0.41421357f);
let _e1266 = select(_e1261, ((_e1261 - 1f) / (_e1261 + 1f)), _e1262);
let _e1267 = (_e1266 * _e1266);
let _e1282 = (select(0f, 0.7853982f, _e1262) + (_e1266 + ((_e1266 * _e1267) * (-0.33333334f + (_e1267 * (0.2f + (_e1267 * (-0.14285713f + (_e1267 * (0.11111111f + (_e1267 * (-0.09090909f + (_e1267 * 0.0585f)))))))))))));
let _e1285 = select(_e1282, (1.5707964f - _e1282), (_e1254 > _e1251));
let _e1288 = select(_e1285, (3.1415927f - _e1285), (_e1161 < 0f));
let _e1294 = (1f - (_e1185 * _e1185));
let _e1297 = sqrt(select(0f, _e1294, (_e1294 > 0f)));
let _e1300 = (_e1248 / select(1e-3f, _e1297, (_e1297 > 1e-3f)));
let _e1301 = ((select(_e1288, -(_e1288), (_e1173 < 0f)) / _e1245) * 0.5f);
let _e1303 = select(-8e6f, _e1301, (_e1301 > -8e6f));
let _e1305 = select(8e6f, _e1303, (_e1303 < 8e6f));
let _e1312 = select(0i, select(select(i32(_e1305), i32(-2147483648), (_e1305 < -2147483600f)), 2147483647i, (_e1305 > 2147483500f)), (_e1305 == _e1305));
let _e1319 = ((_e1301 - f32((_e1312 - select(0i, 1i, (_e1305 < f32(_e1312)))))) * 2f);
let _e1327 = ((select(select((_e1319 - 2f), (1f - _e1319), (_e1319 < 1.5f)), _e1319, (_e1319 < 0.5f)) * 2f) / _e1300);
let _e1329 = select(-1f, _e1327, (_e1327 > -1f));
let _e1332 = (2f - _e1300);
let _e1334 = select(0f, _e1332, (_e1332 > 0f));
let _e1339 = select(-1f, _e1185, (_e1185 > -1f));
let _e1341 = select(1f, _e1339, (_e1339 < 1f));
let _e1344 = ((1f - _e1341) * (1f + _e1341));
let _e1347 = sqrt(select(0f, _e1344, (_e1344 > 0f)));
let _e1350 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
let _e1353 = bitcast<f32>((bitcast<u32>(_e1341) & 2147483647u));
let _e1357 = select(_e1353, _e1350, (_e1350 > _e1353));
let _e1360 = (select(_e1353, _e1350, (_e1350 < _e1353)) / select(1.1754944e-38f, _e1357, (_e1357 > 1.1754944e-38f)));
let _e1361 = (_e1360 > 0.41421357f);
let _e1365 = select(_e1360, ((_e1360 - 1f) / (_e1360 + 1f)), _e1361);
let _e1366 = (_e1365 * _e1365);
let _e1381 = (select(0f, 0.7853982f, _e1361) + (_e1365 + ((_e1365 * _e1366) * (-0.33333334f + (_e1366 * (0.2f + (_e1366 * (-0.14285713f + (_e1366 * (0.11111111f + (_e1366 * (-0.09090909f + (_e1366 * 0.0585f)))))))))))));
let _e1384 = select(_e1381, (1.5707964f - _e1381), (_e1353 > _e1350));
let _e1387 = select(_e1384, (3.1415927f - _e1384), (_e1347 < 0f));
let _e1392 = ((select(_e1387, -(_e1387), (_e1341 < 0f)) / _e1245) * 0.5f);
let _e1394 = select(-8e6f, _e1392, (_e1392 > -8e6f));
let _e1396 = select(8e6f, _e1394, (_e1394 < 8e6f));
let _e1403 = select(0i, select(select(i32(_e1396), i32(-2147483648), (_e1396 < -2147483600f)), 2147483647i, (_e1396 > 2147483500f)), (_e1396 == _e1396));
let _e1410 = ((_e1392 - f32((_e1403 - select(0i, 1i, (_e1396 < f32(_e1403)))))) * 2f);
let _e1418 = ((select(select((_e1410 - 2f), (1f - _e1410), (_e1410 < 1.5f)), _e1410, (_e1410 < 0.5f)) * 2f) / _e1248);
let _e1420 = select(-1f, _e1418, (_e1418 > -1f));
let _e1423 = (2f - _e1248);
let _e1425 = select(0f, _e1423, (_e1423 > 0f));
let _e1431 = (0.5f + ((0.5f * (select(1f, _e1329, (_e1329 < 1f)) * select(1f, _e1334, (_e1334 < 1f)))) * (select(1f, _e1420, (_e1420 < 1f)) * select(1f, _e1425, (_e1425 < 1f)))));
phi_4311_ = vec3<f32>((_e1193.member + ((_e1201.member - _e1193.member) * _e1431)), (_e1193.member_1 + ((_e1201.member_1 - _e1193.member_1) * _e1431)), (_e1193.member_2 + ((_e1201.member_2 - _e1193.member_2) * _e1431)));
} else {
let _e1445 = global_1.member.member_16.member_1;
let _e1446 = bitcast<i32>(_e1445);
let _e1451 = global_1.member.member_16.member_3;
let _e1453 = f32(bitcast<i32>(_e1451));
let _e1455 = (2f * 3.1415927f);
let _e1456 = ((_e1149 * f32(_e1446)) / _e1455);
let _e1458 = select(1e-6f, _e1456, (_e1456 > 1e-6f));
let _e1461 = bitcast<u32>(select(1.1754944e-38f, _e1458, (_e1458 > 1.1754944e-38f)));
let _e1462 = (_e1461 & 8388607u);
let _e1464 = select(0u, 1u, (_e1462 > 3474675u));
let _e1475 = bitcast<f32>((_e1462 | ((127u - _e1464) << bitcast<u32>(23i))));
let _e1478 = ((_e1475 - 1f) / (_e1475 + 1f));
let _e1479 = (_e1478 * _e1478);
let _e1494 = (f32(((bitcast<i32>((_e1461 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e1464))) + (((2f * _e1478) + ((_e1478 * _e1479) * (0.6666667f + (_e1479 * (0.4f + (_e1479 * (0.2857143f + (_e1479 * (0.22222222f + (_e1479 * 0.18181819f)))))))))) * 1.442695f));
let _e1495 = (_e1453 - 1f);
let _e1497 = select(0f, _e1494, (_e1494 > 0f));
let _e1499 = select(_e1495, _e1497, (_e1497 < _e1495));
let _e1500 = (_e1453 - 2f);
let _e1502 = select(0f, _e1500, (_e1500 > 0f));
let _e1504 = select(0f, _e1499, (_e1499 > 0f));
let _e1506 = select(_e1502, _e1504, (_e1504 < _e1502));
let _e1513 = select(0i, select(select(i32(_e1506), i32(-2147483648), (_e1506 < -2147483600f)), 2147483647i, (_e1506 > 2147483500f)), (_e1506 == _e1506));
let _e1517 = (_e1513 - select(0i, 1i, (_e1506 < f32(_e1513))));
let _e1520 = bitcast<f32>((bitcast<u32>(_e1173) & 2147483647u));
let _e1523 = bitcast<f32>((bitcast<u32>(_e1161) & 2147483647u));
let _e1527 = select(_e1523, _e1520, (_e1520 > _e1523));
let _e1530 = (select(_e1523, _e1520, (_e1520 < _e1523)) / select(1.1754944e-38f, _e1527, (_e1527 > 1.1754944e-38f)));
let _e1531 = (_e1530 > 0.41421357f);
let _e1535 = select(_e1530, ((_e1530 - 1f) / (_e1530 + 1f)), _e1531);
let _e1536 = (_e1535 * _e1535);
let _e1551 = (select(0f, 0.7853982f, _e1531) + (_e1535 + ((_e1535 * _e1536) * (-0.33333334f + (_e1536 * (0.2f + (_e1536 * (-0.14285713f + (_e1536 * (0.11111111f + (_e1536 * (-0.09090909f + (_e1536 * 0.0585f)))))))))))));
let _e1554 = select(_e1551, (1.5707964f - _e1551), (_e1523 > _e1520));
let _e1557 = select(_e1554, (3.1415927f - _e1554), (_e1173 < 0f));
let _e1562 = (0.5f - (select(_e1557, -(_e1557), (_e1161 < 0f)) / _e1455));
let _e1564 = select(-1f, _e1185, (_e1185 > -1f));
let _e1566 = select(1f, _e1564, (_e1564 < 1f));
let _e1569 = ((1f - _e1566) * (1f + _e1566));
let _e1572 = sqrt(select(0f, _e1569, (_e1569 > 0f)));
let _e1575 = bitcast<f32>((bitcast<u32>(_e1572) & 2147483647u));
let _e1578 = bitcast<f32>((bitcast<u32>(_e1566) & 2147483647u));
let _e1582 = select(_e1578, _e1575, (_e1575 > _e1578));
let _e1585 = (select(_e1578, _e1575, (_e1575 < _e1578)) / select(1.1754944e-38f, _e1582, (_e1582 > 1.1754944e-38f)));
let _e1586 = (_e1585 > 0.41421357f);
let _e1590 = select(_e1585, ((_e1585 - 1f) / (_e1585 + 1f)), _e1586);
let _e1591 = (_e1590 * _e1590);
let _e1606 = (select(0f, 0.7853982f, _e1586) + (_e1590 + ((_e1590 * _e1591) * (-0.33333334f + (_e1591 * (0.2f + (_e1591 * (-0.14285713f + (_e1591 * (0.11111111f + (_e1591 * (-0.09090909f + (_e1591 * 0.0585f)))))))))))));
let _e1609 = select(_e1606, (1.5707964f - _e1606), (_e1578 > _e1575));
let _e1612 = select(_e1609, (3.1415927f - _e1609), (_e1572 < 0f));
let _e1617 = (0.5f - (select(_e1612, -(_e1612), (_e1566 < 0f)) / 3.1415927f));
let _e1621 = global_1.member.member_16.member_2;
let _e1622 = bitcast<i32>(_e1621);
phi_3530_ = 0i;
phi_3533_ = 0i;
phi_3535_ = _e1622;
phi_3537_ = _e1446;
loop {
let _e1624 = phi_3530_;
let _e1626 = phi_3533_;
let _e1628 = phi_3535_;
let _e1630 = phi_3537_;
local_37 = _e1630;
local_38 = _e1628;
local_39 = _e1630;
local_40 = _e1630;
local_41 = _e1630;
local_42 = _e1630;
local_43 = _e1630;
local_44 = _e1630;
local_45 = _e1628;
local_46 = _e1628;
local_47 = _e1628;
local_48 = _e1628;
local_49 = _e1630;
local_50 = _e1626;
local_51 = _e1630;
local_52 = _e1626;
let _e1631 = (_e1624 < _e1517);
if _e1631 {
if (_e1630 > 1i) {
phi_3552_ = (_e1630 >> bitcast<u32>(1i));
} else {
phi_3552_ = 1i;
}
let _e1638 = phi_3552_;
if (_e1628 > 1i) {
phi_3558_ = (_e1628 >> bitcast<u32>(1i));
} else {
phi_3558_ = 1i;
}
let _e1643 = phi_3558_;
phi_3531_ = (_e1624 + 1i);
phi_3534_ = (_e1626 + (_e1630 * _e1628));
phi_3536_ = _e1643;
phi_3538_ = _e1638;
} else {
phi_3531_ = i32();
phi_3534_ = i32();
phi_3536_ = i32();
phi_3538_ = i32();
}
let _e1646 = phi_3531_;
let _e1648 = phi_3534_;
let _e1650 = phi_3536_;
let _e1652 = phi_3538_;
continue;
continuing {
phi_3530_ = _e1646;
phi_3533_ = _e1648;
phi_3535_ = _e1650;
phi_3537_ = _e1652;
break if !(_e1631);
}
}
let _e1655 = local_37;
let _e1656 = f32(_e1655);
let _e1658 = ((_e1562 * _e1656) - 0.5f);
let _e1660 = local_38;
let _e1661 = f32(_e1660);
let _e1663 = ((_e1617 * _e1661) - 0.5f);
let _e1665 = select(-1f, _e1658, (_e1658 > -1f));
let _e1667 = select(_e1656, _e1665, (_e1665 < _e1656));
let _e1674 = select(0i, select(select(i32(_e1667), i32(-2147483648), (_e1667 < -2147483600f)), 2147483647i, (_e1667 > 2147483500f)), (_e1667 == _e1667));
let _e1678 = (_e1674 - select(0i, 1i, (_e1667 < f32(_e1674))));
let _e1680 = select(-1f, _e1663, (_e1663 > -1f));
let _e1682 = select(_e1661, _e1680, (_e1680 < _e1661));
let _e1689 = select(0i, select(select(i32(_e1682), i32(-2147483648), (_e1682 < -2147483600f)), 2147483647i, (_e1682 > 2147483500f)), (_e1682 == _e1682));
let _e1693 = (_e1689 - select(0i, 1i, (_e1682 < f32(_e1689))));
let _e1695 = (_e1658 - f32(_e1678));
let _e1697 = (_e1663 - f32(_e1693));
let _e1699 = select(0f, _e1697, (_e1697 > 0f));
let _e1701 = select(1f, _e1699, (_e1699 < 1f));
if (_e1678 < 0i) {
let _e1704 = local_39;
phi_3633_ = (_e1678 + _e1704);
} else {
phi_3633_ = _e1678;
}
let _e1707 = phi_3633_;
let _e1709 = local_40;
if (_e1707 >= _e1709) {
let _e1712 = local_41;
phi_3639_ = (_e1707 - _e1712);
} else {
phi_3639_ = _e1707;
}
let _e1715 = phi_3639_;
let _e1716 = (_e1678 + 1i);
if (_e1716 < 0i) {
let _e1719 = local_42;
phi_3646_ = (_e1716 + _e1719);
} else {
phi_3646_ = _e1716;
}
let _e1722 = phi_3646_;
let _e1724 = local_43;
if (_e1722 >= _e1724) {
let _e1727 = local_44;
phi_3652_ = (_e1722 - _e1727);
} else {
phi_3652_ = _e1722;
}
let _e1730 = phi_3652_;
let _e1732 = select(_e1693, 0i, (_e1693 < 0i));
let _e1734 = local_45;
if (_e1732 >= _e1734) {
let _e1737 = local_46;
phi_3663_ = (_e1737 - 1i);
} else {
phi_3663_ = _e1732;
}
let _e1740 = phi_3663_;
let _e1741 = (_e1693 + 1i);
let _e1743 = select(_e1741, 0i, (_e1741 < 0i));
let _e1745 = local_47;
if (_e1743 >= _e1745) {
let _e1748 = local_48;
phi_3675_ = (_e1748 - 1i);
} else {
phi_3675_ = _e1743;
}
let _e1751 = phi_3675_;
let _e1753 = local_49;
let _e1756 = local_50;
let _e1757 = (_e1756 + (_e1740 * _e1753));
let _e1759 = local_51;
let _e1762 = local_52;
let _e1763 = (_e1762 + (_e1751 * _e1759));
let _e1765 = (3i * (_e1757 + _e1715));
let _e1767 = (bitcast<i32>(_e148) - 1i);
let _e1769 = select(_e1767, _e1765, (_e1765 < _e1767));
let _e1775 = global_3.member[bitcast<u32>(select(0i, _e1769, (_e1769 > 0i)))];
let _e1776 = (_e1765 + 1i);
let _e1778 = select(_e1767, _e1776, (_e1776 < _e1767));
let _e1784 = global_3.member[bitcast<u32>(select(0i, _e1778, (_e1778 > 0i)))];
let _e1785 = (_e1765 + 2i);
let _e1787 = select(_e1767, _e1785, (_e1785 < _e1767));
let _e1793 = global_3.member[bitcast<u32>(select(0i, _e1787, (_e1787 > 0i)))];
let _e1795 = (3i * (_e1757 + _e1730));
let _e1797 = select(_e1767, _e1795, (_e1795 < _e1767));
let _e1803 = global_3.member[bitcast<u32>(select(0i, _e1797, (_e1797 > 0i)))];
let _e1804 = (_e1795 + 1i);
let _e1806 = select(_e1767, _e1804, (_e1804 < _e1767));
let _e1812 = global_3.member[bitcast<u32>(select(0i, _e1806, (_e1806 > 0i)))];
let _e1813 = (_e1795 + 2i);
let _e1815 = select(_e1767, _e1813, (_e1813 < _e1767));
let _e1821 = global_3.member[bitcast<u32>(select(0i, _e1815, (_e1815 > 0i)))];
let _e1823 = (3i * (_e1763 + _e1715));
let _e1825 = select(_e1767, _e1823, (_e1823 < _e1767));
let _e1831 = global_3.member[bitcast<u32>(select(0i, _e1825, (_e1825 > 0i)))];
let _e1832 = (_e1823 + 1i);
let _e1834 = select(_e1767, _e1832, (_e1832 < _e1767));
let _e1840 = global_3.member[bitcast<u32>(select(0i, _e1834, (_e1834 > 0i)))];
let _e1841 = (_e1823 + 2i);
let _e1843 = select(_e1767, _e1841, (_e1841 < _e1767));
let _e1849 = global_3.member[bitcast<u32>(select(0i, _e1843, (_e1843 > 0i)))];
let _e1851 = (3i * (_e1763 + _e1730));
let _e1853 = select(_e1767, _e1851, (_e1851 < _e1767));
let _e1859 = global_3.member[bitcast<u32>(select(0i, _e1853, (_e1853 > 0i)))];
let _e1860 = (_e1851 + 1i);
let _e1862 = select(_e1767, _e1860, (_e1860 < _e1767));
let _e1868 = global_3.member[bitcast<u32>(select(0i, _e1862, (_e1862 > 0i)))];
let _e1869 = (_e1851 + 2i);
let _e1871 = select(_e1767, _e1869, (_e1869 < _e1767));
let _e1877 = global_3.member[bitcast<u32>(select(0i, _e1871, (_e1871 > 0i)))];
let _e1884 = (_e1775 + ((_e1803 - _e1775) * _e1695));
let _e1885 = (_e1784 + ((_e1812 - _e1784) * _e1695));
let _e1886 = (_e1793 + ((_e1821 - _e1793) * _e1695));
let _e1902 = (_e1884 + (((_e1831 + ((_e1859 - _e1831) * _e1695)) - _e1884) * _e1701));
let _e1903 = (_e1885 + (((_e1840 + ((_e1868 - _e1840) * _e1695)) - _e1885) * _e1701));
let _e1904 = (_e1886 + (((_e1849 + ((_e1877 - _e1849) * _e1695)) - _e1886) * _e1701));
phi_3911_ = 0i;
phi_3914_ = 0i;
phi_3916_ = _e1622;
phi_3918_ = _e1446;
loop {
let _e1907 = phi_3911_;
let _e1909 = phi_3914_;
let _e1911 = phi_3916_;
let _e1913 = phi_3918_;
local_53 = _e1913;
local_54 = _e1911;
local_55 = _e1913;
local_56 = _e1913;
local_57 = _e1913;
local_58 = _e1913;
local_59 = _e1913;
local_60 = _e1913;
local_61 = _e1911;
local_62 = _e1911;
local_63 = _e1911;
local_64 = _e1911;
local_65 = _e1913;
local_66 = _e1909;
local_67 = _e1913;
local_68 = _e1909;
let _e1914 = (_e1907 < (_e1517 + 1i));
if _e1914 {
if (_e1913 > 1i) {
phi_3933_ = (_e1913 >> bitcast<u32>(1i));
} else {
phi_3933_ = 1i;
}
let _e1921 = phi_3933_;
if (_e1911 > 1i) {
phi_3939_ = (_e1911 >> bitcast<u32>(1i));
} else {
phi_3939_ = 1i;
}
let _e1926 = phi_3939_;
phi_3912_ = (_e1907 + 1i);
phi_3915_ = (_e1909 + (_e1913 * _e1911));
phi_3917_ = _e1926;
phi_3919_ = _e1921;
} else {
phi_3912_ = i32();
phi_3915_ = i32();
phi_3917_ = i32();
phi_3919_ = i32();
}
let _e1929 = phi_3912_;
let _e1931 = phi_3915_;
let _e1933 = phi_3917_;
let _e1935 = phi_3919_;
continue;
continuing {
phi_3911_ = _e1929;
phi_3914_ = _e1931;
phi_3916_ = _e1933;
phi_3918_ = _e1935;
break if !(_e1914);
}
}
let _e1938 = local_53;
let _e1939 = f32(_e1938);
let _e1941 = ((_e1562 * _e1939) - 0.5f);
let _e1943 = local_54;
let _e1944 = f32(_e1943);
let _e1946 = ((_e1617 * _e1944) - 0.5f);
let _e1948 = select(-1f, _e1941, (_e1941 > -1f));
let _e1950 = select(_e1939, _e1948, (_e1948 < _e1939));
let _e1957 = select(0i, select(select(i32(_e1950), i32(-2147483648), (_e1950 < -2147483600f)), 2147483647i, (_e1950 > 2147483500f)), (_e1950 == _e1950));
let _e1961 = (_e1957 - select(0i, 1i, (_e1950 < f32(_e1957))));
let _e1963 = select(-1f, _e1946, (_e1946 > -1f));
let _e1965 = select(_e1944, _e1963, (_e1963 < _e1944));
let _e1972 = select(0i, select(select(i32(_e1965), i32(-2147483648), (_e1965 < -2147483600f)), 2147483647i, (_e1965 > 2147483500f)), (_e1965 == _e1965));
let _e1976 = (_e1972 - select(0i, 1i, (_e1965 < f32(_e1972))));
let _e1978 = (_e1941 - f32(_e1961));
let _e1980 = (_e1946 - f32(_e1976));
let _e1982 = select(0f, _e1980, (_e1980 > 0f));
let _e1984 = select(1f, _e1982, (_e1982 < 1f));
if (_e1961 < 0i) {
let _e1987 = local_55;
phi_4014_ = (_e1961 + _e1987);
} else {
phi_4014_ = _e1961;
}
let _e1990 = phi_4014_;
let _e1992 = local_56;
if (_e1990 >= _e1992) {
let _e1995 = local_57;
phi_4020_ = (_e1990 - _e1995);
} else {
phi_4020_ = _e1990;
}
let _e1998 = phi_4020_;
let _e1999 = (_e1961 + 1i);
if (_e1999 < 0i) {
let _e2002 = local_58;
phi_4027_ = (_e1999 + _e2002);
} else {
phi_4027_ = _e1999;
}
let _e2005 = phi_4027_;
let _e2007 = local_59;
if (_e2005 >= _e2007) {
let _e2010 = local_60;
phi_4033_ = (_e2005 - _e2010);
} else {
phi_4033_ = _e2005;
}
let _e2013 = phi_4033_;
let _e2015 = select(_e1976, 0i, (_e1976 < 0i));
let _e2017 = local_61;
if (_e2015 >= _e2017) {
let _e2020 = local_62;
phi_4044_ = (_e2020 - 1i);
} else {
phi_4044_ = _e2015;
}
let _e2023 = phi_4044_;
let _e2024 = (_e1976 + 1i);
let _e2026 = select(_e2024, 0i, (_e2024 < 0i));
let _e2028 = local_63;
if (_e2026 >= _e2028) {
let _e2031 = local_64;
phi_4056_ = (_e2031 - 1i);
} else {
phi_4056_ = _e2026;
}
let _e2034 = phi_4056_;
let _e2036 = local_65;
let _e2039 = local_66;
let _e2040 = (_e2039 + (_e2023 * _e2036));
let _e2042 = local_67;
let _e2045 = local_68;
let _e2046 = (_e2045 + (_e2034 * _e2042));
let _e2048 = (3i * (_e2040 + _e1998));
let _e2050 = select(_e1767, _e2048, (_e2048 < _e1767));
let _e2056 = global_3.member[bitcast<u32>(select(0i, _e2050, (_e2050 > 0i)))];
let _e2057 = (_e2048 + 1i);
let _e2059 = select(_e1767, _e2057, (_e2057 < _e1767));
let _e2065 = global_3.member[bitcast<u32>(select(0i, _e2059, (_e2059 > 0i)))];
let _e2066 = (_e2048 + 2i);
let _e2068 = select(_e1767, _e2066, (_e2066 < _e1767));
let _e2074 = global_3.member[bitcast<u32>(select(0i, _e2068, (_e2068 > 0i)))];
let _e2076 = (3i * (_e2040 + _e2013));
let _e2078 = select(_e1767, _e2076, (_e2076 < _e1767));
let _e2084 = global_3.member[bitcast<u32>(select(0i, _e2078, (_e2078 > 0i)))];
let _e2085 = (_e2076 + 1i);
let _e2087 = select(_e1767, _e2085, (_e2085 < _e1767));
let _e2093 = global_3.member[bitcast<u32>(select(0i, _e2087, (_e2087 > 0i)))];
let _e2094 = (_e2076 + 2i);
let _e2096 = select(_e1767, _e2094, (_e2094 < _e1767));
let _e2102 = global_3.member[bitcast<u32>(select(0i, _e2096, (_e2096 > 0i)))];
let _e2104 = (3i * (_e2046 + _e1998));
let _e2106 = select(_e1767, _e2104, (_e2104 < _e1767));
let _e2112 = global_3.member[bitcast<u32>(select(0i, _e2106, (_e2106 > 0i)))];
let _e2113 = (_e2104 + 1i);
let _e2115 = select(_e1767, _e2113, (_e2113 < _e1767));
let _e2121 = global_3.member[bitcast<u32>(select(0i, _e2115, (_e2115 > 0i)))];
let _e2122 = (_e2104 + 2i);
let _e2124 = select(_e1767, _e2122, (_e2122 < _e1767));
let _e2130 = global_3.member[bitcast<u32>(select(0i, _e2124, (_e2124 > 0i)))];
let _e2132 = (3i * (_e2046 + _e2013));
let _e2134 = select(_e1767, _e2132, (_e2132 < _e1767));
let _e2140 = global_3.member[bitcast<u32>(select(0i, _e2134, (_e2134 > 0i)))];
let _e2141 = (_e2132 + 1i);
let _e2143 = select(_e1767, _e2141, (_e2141 < _e1767));
let _e2149 = global_3.member[bitcast<u32>(select(0i, _e2143, (_e2143 > 0i)))];
let _e2150 = (_e2132 + 2i);
let _e2152 = select(_e1767, _e2150, (_e2150 < _e1767));
let _e2158 = global_3.member[bitcast<u32>(select(0i, _e2152, (_e2152 > 0i)))];
let _e2165 = (_e2056 + ((_e2084 - _e2056) * _e1978));
let _e2166 = (_e2065 + ((_e2093 - _e2065) * _e1978));
let _e2167 = (_e2074 + ((_e2102 - _e2074) * _e1978));
let _e2190 = (_e1499 - f32(_e1517));
let _e2192 = select(0f, _e2190, (_e2190 > 0f));
let _e2194 = select(1f, _e2192, (_e2192 < 1f));
let _e2204 = global_1.member.member_16.member_11;
phi_4311_ = vec3<f32>(((_e1902 + (((_e2165 + (((_e2112 + ((_e2140 - _e2112) * _e1978)) - _e2165) * _e1984)) - _e1902) * _e2194)) * _e2204), ((_e1903 + (((_e2166 + (((_e2121 + ((_e2149 - _e2121) * _e1978)) - _e2166) * _e1984)) - _e1903) * _e2194)) * _e2204), ((_e1904 + (((_e2167 + (((_e2130 + ((_e2158 - _e2130) * _e1978)) - _e2167) * _e1984)) - _e1904) * _e2194)) * _e2204));
}
let _e2210 = phi_4311_;
phi_4312_ = _e2210;
}
let _e2212 = phi_4312_;
phi_4313_ = _e2212;
}
let _e2214 = phi_4313_;
let _e2216 = local_8;
let _e2218 = local_7;
let _e2219 = ((16i * _e2216) + _e2218);
let _e2221 = select(_e384, _e2219, (_e2219 < _e384));
let _e2226 = global_2.member[bitcast<u32>(select(0i, _e2221, (_e2221 > 0i)))];
if ((_e159.member_2 == 1u) && (_e2226 == 3f)) {
let _e2229 = local_8;
let _e2231 = local_7;
let _e2232 = ((30i * _e2229) + _e2231);
let _e2234 = select(_e384, _e2232, (_e2232 < _e384));
let _e2239 = global_2.member[bitcast<u32>(select(0i, _e2234, (_e2234 > 0i)))];
let _e2246 = select(0i, select(select(i32(_e2239), i32(-2147483648), (_e2239 < -2147483600f)), 2147483647i, (_e2239 > 2147483500f)), (_e2239 == _e2239));
let _e2247 = local_7;
local_5 = _e2247;
local_6 = _e378;
let _e2248 = local_5;
let _e2250 = select(_e384, _e2248, (_e2248 < _e384));
let _e2255 = global_2.member[bitcast<u32>(select(0i, _e2250, (_e2250 > 0i)))];
let _e2256 = local_6;
let _e2257 = local_5;
let _e2258 = (_e2256 + _e2257);
let _e2260 = select(_e384, _e2258, (_e2258 < _e384));
let _e2265 = global_2.member[bitcast<u32>(select(0i, _e2260, (_e2260 > 0i)))];
let _e2266 = local_6;
let _e2268 = local_5;
let _e2269 = ((2i * _e2266) + _e2268);
let _e2271 = select(_e384, _e2269, (_e2269 < _e384));
let _e2276 = global_2.member[bitcast<u32>(select(0i, _e2271, (_e2271 > 0i)))];
let _e2277 = vec3<f32>(_e2255, _e2265, _e2276);
if (_e2246 < 0i) {
let _e2279 = (_e2246 == -3i);
let _e2285 = global_1.member.member_18.member_1.member.member;
let _e2290 = global_1.member.member_18.member_1.member_1;
let _e2296 = global_1.member.member_18.member.member.member;
let _e2301 = global_1.member.member_18.member.member_1;
let _e2311 = vec3<f32>(select(_e2296.member, _e2285.member, _e2279), select(_e2296.member_1, _e2285.member_1, _e2279), select(_e2296.member_2, _e2285.member_2, _e2279));
phi_5175_ = type_28(_e2277, _e2311, _e2311, vec3<f32>(select(_e2301.member, _e2290.member, _e2279), select(_e2301.member_1, _e2290.member_1, _e2279), select(_e2301.member_2, _e2290.member_2, _e2279)), 0f, false, _e2279);
} else {
let _e2325 = global_1.member.member_1;
let _e2328 = (_e2246 * 19i);
let _e2330 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e2332 = select(_e2330, _e2328, (_e2328 < _e2330));
let _e2338 = global_4.member[bitcast<u32>(select(0i, _e2332, (_e2332 > 0i)))];
let _e2339 = (_e2328 + 1i);
let _e2341 = select(_e2330, _e2339, (_e2339 < _e2330));
let _e2347 = global_4.member[bitcast<u32>(select(0i, _e2341, (_e2341 > 0i)))];
let _e2348 = (_e2328 + 2i);
let _e2350 = select(_e2330, _e2348, (_e2348 < _e2330));
let _e2356 = global_4.member[bitcast<u32>(select(0i, _e2350, (_e2350 > 0i)))];
let _e2357 = (_e2328 + 3i);
let _e2359 = select(_e2330, _e2357, (_e2357 < _e2330));
let _e2365 = global_4.member[bitcast<u32>(select(0i, _e2359, (_e2359 > 0i)))];
let _e2366 = (_e2328 + 4i);
let _e2368 = select(_e2330, _e2366, (_e2366 < _e2330));
let _e2374 = global_4.member[bitcast<u32>(select(0i, _e2368, (_e2368 > 0i)))];
let _e2375 = (_e2328 + 5i);
let _e2377 = select(_e2330, _e2375, (_e2375 < _e2330));
let _e2383 = global_4.member[bitcast<u32>(select(0i, _e2377, (_e2377 > 0i)))];
let _e2384 = (_e2328 + 6i);
let _e2386 = select(_e2330, _e2384, (_e2384 < _e2330));
let _e2392 = global_4.member[bitcast<u32>(select(0i, _e2386, (_e2386 > 0i)))];
let _e2393 = (_e2328 + 7i);
let _e2395 = select(_e2330, _e2393, (_e2393 < _e2330));
let _e2401 = global_4.member[bitcast<u32>(select(0i, _e2395, (_e2395 > 0i)))];
let _e2402 = (_e2328 + 8i);
let _e2404 = select(_e2330, _e2402, (_e2402 < _e2330));
let _e2410 = global_4.member[bitcast<u32>(select(0i, _e2404, (_e2404 > 0i)))];
let _e2411 = (_e2365 - _e2338);
let _e2412 = (_e2374 - _e2347);
let _e2413 = (_e2383 - _e2356);
let _e2414 = (_e2392 - _e2338);
let _e2415 = (_e2401 - _e2347);
let _e2416 = (_e2410 - _e2356);
let _e2419 = ((_e2412 * _e2416) - (_e2413 * _e2415));
let _e2422 = ((_e2413 * _e2414) - (_e2411 * _e2416));
let _e2425 = ((_e2411 * _e2415) - (_e2412 * _e2414));
let _e2426 = (_e2365 - _e2255);
let _e2427 = (_e2374 - _e2265);
let _e2428 = (_e2383 - _e2276);
let _e2429 = (_e2392 - _e2255);
let _e2430 = (_e2401 - _e2265);
let _e2431 = (_e2410 - _e2276);
let _e2445 = (((((_e2427 * _e2431) - (_e2428 * _e2430)) * _e2419) + (((_e2428 * _e2429) - (_e2426 * _e2431)) * _e2422)) + (((_e2426 * _e2430) - (_e2427 * _e2429)) * _e2425));
let _e2447 = select(0f, _e2445, (_e2445 > 0f));
let _e2448 = (_e2338 - _e2255);
let _e2449 = (_e2347 - _e2265);
let _e2450 = (_e2356 - _e2276);
let _e2464 = (((((_e2430 * _e2450) - (_e2431 * _e2449)) * _e2419) + (((_e2431 * _e2448) - (_e2429 * _e2450)) * _e2422)) + (((_e2429 * _e2449) - (_e2430 * _e2448)) * _e2425));
let _e2466 = select(0f, _e2464, (_e2464 > 0f));
let _e2480 = (((((_e2449 * _e2428) - (_e2450 * _e2427)) * _e2419) + (((_e2450 * _e2426) - (_e2448 * _e2428)) * _e2422)) + (((_e2448 * _e2427) - (_e2449 * _e2426)) * _e2425));
let _e2482 = select(0f, _e2480, (_e2480 > 0f));
let _e2484 = ((_e2447 + _e2466) + _e2482);
let _e2486 = select(1e-30f, _e2484, (_e2484 > 1e-30f));
let _e2487 = (_e2447 / _e2486);
let _e2488 = (_e2466 / _e2486);
let _e2489 = (_e2482 / _e2486);
let _e2494 = (((_e2419 * _e2419) + (_e2422 * _e2422)) + (_e2425 * _e2425));
let _e2497 = sqrt(select(0f, _e2494, (_e2494 > 0f)));
let _e2500 = (1f / select(1e-20f, _e2497, (_e2497 > 1e-20f)));
let _e2505 = (_e2328 + 9i);
let _e2507 = select(_e2330, _e2505, (_e2505 < _e2330));
let _e2513 = global_4.member[bitcast<u32>(select(0i, _e2507, (_e2507 > 0i)))];
let _e2514 = (_e2328 + 10i);
let _e2516 = select(_e2330, _e2514, (_e2514 < _e2330));
let _e2522 = global_4.member[bitcast<u32>(select(0i, _e2516, (_e2516 > 0i)))];
let _e2523 = (_e2328 + 11i);
let _e2525 = select(_e2330, _e2523, (_e2523 < _e2330));
let _e2531 = global_4.member[bitcast<u32>(select(0i, _e2525, (_e2525 > 0i)))];
let _e2535 = (_e2328 + 12i);
let _e2537 = select(_e2330, _e2535, (_e2535 < _e2330));
let _e2543 = global_4.member[bitcast<u32>(select(0i, _e2537, (_e2537 > 0i)))];
let _e2544 = (_e2328 + 13i);
let _e2546 = select(_e2330, _e2544, (_e2544 < _e2330));
let _e2552 = global_4.member[bitcast<u32>(select(0i, _e2546, (_e2546 > 0i)))];
let _e2553 = (_e2328 + 14i);
let _e2555 = select(_e2330, _e2553, (_e2553 < _e2330));
let _e2561 = global_4.member[bitcast<u32>(select(0i, _e2555, (_e2555 > 0i)))];
let _e2568 = (_e2328 + 15i);
let _e2570 = select(_e2330, _e2568, (_e2568 < _e2330));
let _e2576 = global_4.member[bitcast<u32>(select(0i, _e2570, (_e2570 > 0i)))];
let _e2577 = (_e2328 + 16i);
let _e2579 = select(_e2330, _e2577, (_e2577 < _e2330));
let _e2585 = global_4.member[bitcast<u32>(select(0i, _e2579, (_e2579 > 0i)))];
let _e2586 = (_e2328 + 17i);
let _e2588 = select(_e2330, _e2586, (_e2586 < _e2330));
let _e2594 = global_4.member[bitcast<u32>(select(0i, _e2588, (_e2588 > 0i)))];
let _e2598 = (((_e2513 * _e2487) + (_e2543 * _e2488)) + (_e2576 * _e2489));
let _e2599 = (((_e2522 * _e2487) + (_e2552 * _e2488)) + (_e2585 * _e2489));
let _e2600 = (((_e2531 * _e2487) + (_e2561 * _e2488)) + (_e2594 * _e2489));
let _e2605 = (((_e2598 * _e2598) + (_e2599 * _e2599)) + (_e2600 * _e2600));
let _e2608 = sqrt(select(0f, _e2605, (_e2605 > 0f)));
let _e2611 = (1f / select(1e-20f, _e2608, (_e2608 > 1e-20f)));
let _e2616 = (_e2328 + 18i);
let _e2618 = select(_e2330, _e2616, (_e2616 < _e2330));
let _e2624 = global_4.member[bitcast<u32>(select(0i, _e2618, (_e2618 > 0i)))];
let _e2633 = (select(select(0i, select(select(i32(_e2624), i32(-2147483648), (_e2624 < -2147483600f)), 2147483647i, (_e2624 > 2147483500f)), (_e2624 == _e2624)), _e2246, ((_e2325 & 4u) != 0u)) * 10i);
let _e2635 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e2637 = select(_e2635, _e2633, (_e2633 < _e2635));
let _e2643 = global_5.member[bitcast<u32>(select(0i, _e2637, (_e2637 > 0i)))];
let _e2644 = (_e2633 + 1i);
let _e2646 = select(_e2635, _e2644, (_e2644 < _e2635));
let _e2652 = global_5.member[bitcast<u32>(select(0i, _e2646, (_e2646 > 0i)))];
let _e2653 = (_e2633 + 2i);
let _e2655 = select(_e2635, _e2653, (_e2653 < _e2635));
let _e2661 = global_5.member[bitcast<u32>(select(0i, _e2655, (_e2655 > 0i)))];
let _e2665 = (_e2633 + 3i);
let _e2667 = select(_e2635, _e2665, (_e2665 < _e2635));
let _e2673 = global_5.member[bitcast<u32>(select(0i, _e2667, (_e2667 > 0i)))];
let _e2674 = (_e2633 + 4i);
let _e2676 = select(_e2635, _e2674, (_e2674 < _e2635));
let _e2682 = global_5.member[bitcast<u32>(select(0i, _e2676, (_e2676 > 0i)))];
let _e2683 = (_e2633 + 5i);
let _e2685 = select(_e2635, _e2683, (_e2683 < _e2635));
let _e2691 = global_5.member[bitcast<u32>(select(0i, _e2685, (_e2685 > 0i)))];
let _e2698 = (_e2633 + 6i);
let _e2700 = select(_e2635, _e2698, (_e2698 < _e2635));
let _e2706 = global_5.member[bitcast<u32>(select(0i, _e2700, (_e2700 > 0i)))];
let _e2707 = (_e2633 + 7i);
let _e2709 = select(_e2635, _e2707, (_e2707 < _e2635));
let _e2715 = global_5.member[bitcast<u32>(select(0i, _e2709, (_e2709 > 0i)))];
let _e2716 = (_e2633 + 8i);
let _e2718 = select(_e2635, _e2716, (_e2716 < _e2635));
let _e2724 = global_5.member[bitcast<u32>(select(0i, _e2718, (_e2718 > 0i)))];
let _e2732 = (_e2633 + 9i);
let _e2734 = select(_e2635, _e2732, (_e2732 < _e2635));
let _e2740 = global_5.member[bitcast<u32>(select(0i, _e2734, (_e2734 > 0i)))];
phi_5175_ = type_28(_e2277, vec3<f32>((_e2419 * _e2500), (_e2422 * _e2500), (_e2425 * _e2500)), vec3<f32>((_e2598 * _e2611), (_e2599 * _e2611), (_e2600 * _e2611)), vec3<f32>((((_e2643 * _e2487) + (_e2673 * _e2488)) + (_e2706 * _e2489)), (((_e2652 * _e2487) + (_e2682 * _e2488)) + (_e2715 * _e2489)), (((_e2661 * _e2487) + (_e2691 * _e2488)) + (_e2724 * _e2489))), _e2740, true, false);
}
let _e2743 = phi_5175_;
let _e2752 = (((_e2743.member_1.x * _e1038) + (_e2743.member_1.y * _e1049)) + (_e2743.member_1.z * _e1060));
let _e2754 = select(1f, -1f, (_e2752 > 0f));
let _e2766 = select(_e2754, -(_e2754), ((((_e2743.member_2.x * _e2743.member_1.x) + (_e2743.member_2.y * _e2743.member_1.y)) + (_e2743.member_2.z * _e2743.member_1.z)) < 0f));
let _e2767 = (_e2743.member_2.x * _e2766);
let _e2768 = (_e2743.member_2.y * _e2766);
let _e2769 = (_e2743.member_2.z * _e2766);
let _e2778 = ((((_e2767 * _e1038) + (_e2768 * _e1049)) + (_e2769 * _e1060)) > 0f);
let _e2779 = select(_e2767, (_e2743.member_1.x * _e2754), _e2778);
let _e2780 = select(_e2768, (_e2743.member_1.y * _e2754), _e2778);
let _e2781 = select(_e2769, (_e2743.member_1.z * _e2754), _e2778);
let _e2786 = global_1.member.member_19.member_2;
let _e2794 = global_1.member.member_19.member;
let _e2795 = (_e2794 == 0u);
if _e2795 {
let _e2799 = global_1.member.member_19.member_1;
phi_5765_ = type_27(vec3<f32>(_e2799.member, _e2799.member_1, _e2799.member_2), vec3<f32>(_e2786.member, _e2786.member_1, _e2786.member_2));
} else {
let _e2808 = global_1.member.member_19.member_3;
let _e2813 = (_e2743.member.x - _e2808.member);
let _e2815 = (_e2743.member.y - _e2808.member_1);
let _e2817 = (_e2743.member.z - _e2808.member_2);
let _e2822 = (((_e2813 * _e2813) + (_e2815 * _e2815)) + (_e2817 * _e2817));
let _e2824 = select(1e-12f, _e2822, (_e2822 > 1e-12f));
let _e2825 = (1f / _e2824);
let _e2829 = vec3<f32>((_e2786.member * _e2825), (_e2786.member_1 * _e2825), (_e2786.member_2 * _e2825));
if (_e2794 == 2u) {
let _e2834 = global_1.member.member_19.member_1;
let _e2842 = (((_e2834.member * _e2813) + (_e2834.member_1 * _e2815)) + (_e2834.member_2 * _e2817));
let _e2845 = (1f / select(1e-20f, _e2842, (_e2842 > 1e-20f)));
let _e2850 = global_1.member.member_19.member_4.member;
let _e2859 = ((((_e2850.member * _e2813) + (_e2850.member_1 * _e2815)) + (_e2850.member_2 * _e2817)) * _e2845);
let _e2864 = global_1.member.member_19.member_4.member_1;
let _e2873 = ((((_e2864.member * _e2813) + (_e2864.member_1 * _e2815)) + (_e2864.member_2 * _e2817)) * _e2845);
let _e2878 = global_1.member.member_19.member_4.member_2;
let _e2881 = ((_e2859 * _e2859) + (_e2873 * _e2873));
let _e2890 = global_1.member.member_19.member_4.member_3;
let _e2891 = ((_e2878 - sqrt(select(0f, _e2881, (_e2881 > 0f)))) * _e2890);
let _e2893 = select(0f, _e2891, (_e2891 > 0f));
let _e2895 = select(1f, _e2893, (_e2893 < 1f));
let _e2901 = select(0f, ((_e2895 * _e2895) * (3f - (2f * _e2895))), (_e2842 > 0f));
let _e2906 = global_1.member.member_19.member_4.member_5;
if ((_e2906 > 0u) && (_e2901 > 0f)) {
let _e2910 = (0.5f / _e2878);
let _e2920 = global_1.member.member_19.member_4.member_6;
let _e2921 = bitcast<i32>(_e2920);
local_4 = bitcast<i32>(_e2906);
let _e2922 = local_4;
let _e2924 = f32((_e2922 - 1i));
let _e2926 = f32((_e2921 - 1i));
let _e2927 = local_4;
let _e2930 = (((0.5f + (_e2859 * _e2910)) * f32(_e2927)) - 0.5f);
let _e2932 = select(0f, _e2930, (_e2930 > 0f));
let _e2934 = select(_e2924, _e2932, (_e2932 < _e2924));
let _e2937 = (((0.5f - (_e2873 * _e2910)) * f32(_e2921)) - 0.5f);
let _e2939 = select(0f, _e2937, (_e2937 > 0f));
let _e2941 = select(_e2926, _e2939, (_e2939 < _e2926));
let _e2943 = select(0f, _e2934, (_e2934 > 0f));
let _e2945 = select(_e2924, _e2943, (_e2943 < _e2924));
let _e2952 = select(0i, select(select(i32(_e2945), i32(-2147483648), (_e2945 < -2147483600f)), 2147483647i, (_e2945 > 2147483500f)), (_e2945 == _e2945));
let _e2956 = (_e2952 - select(0i, 1i, (_e2945 < f32(_e2952))));
let _e2958 = select(0f, _e2941, (_e2941 > 0f));
let _e2960 = select(_e2926, _e2958, (_e2958 < _e2926));
let _e2967 = select(0i, select(select(i32(_e2960), i32(-2147483648), (_e2960 < -2147483600f)), 2147483647i, (_e2960 > 2147483500f)), (_e2960 == _e2960));
let _e2971 = (_e2967 - select(0i, 1i, (_e2960 < f32(_e2967))));
let _e2973 = (_e2934 - f32(_e2956));
let _e2975 = (_e2941 - f32(_e2971));
let _e2976 = (_e2956 + 1i);
let _e2977 = local_4;
let _e2979 = select(_e2956, _e2976, (_e2976 < _e2977));
let _e2980 = (_e2971 + 1i);
let _e2982 = select(_e2971, _e2980, (_e2980 < _e2921));
let _e2987 = global_1.member.member_19.member_4.member_4;
let _e2988 = bitcast<i32>(_e2987);
let _e2989 = local_4;
let _e2993 = (_e2988 + (3i * ((_e2971 * _e2989) + _e2956)));
let _e2995 = (bitcast<i32>(_e148) - 1i);
let _e2997 = select(_e2995, _e2993, (_e2993 < _e2995));
let _e3002 = global_3.member[bitcast<u32>(select(0i, _e2997, (_e2997 > 0i)))];
let _e3003 = (_e2993 + 1i);
let _e3005 = select(_e2995, _e3003, (_e3003 < _e2995));
let _e3010 = global_3.member[bitcast<u32>(select(0i, _e3005, (_e3005 > 0i)))];
let _e3011 = (_e2993 + 2i);
let _e3013 = select(_e2995, _e3011, (_e3011 < _e2995));
let _e3018 = global_3.member[bitcast<u32>(select(0i, _e3013, (_e3013 > 0i)))];
let _e3019 = local_4;
let _e3023 = (_e2988 + (3i * ((_e2971 * _e3019) + _e2979)));
let _e3025 = select(_e2995, _e3023, (_e3023 < _e2995));
let _e3030 = global_3.member[bitcast<u32>(select(0i, _e3025, (_e3025 > 0i)))];
let _e3031 = (_e3023 + 1i);
let _e3033 = select(_e2995, _e3031, (_e3031 < _e2995));
let _e3038 = global_3.member[bitcast<u32>(select(0i, _e3033, (_e3033 > 0i)))];
let _e3039 = (_e3023 + 2i);
let _e3041 = select(_e2995, _e3039, (_e3039 < _e2995));
let _e3046 = global_3.member[bitcast<u32>(select(0i, _e3041, (_e3041 > 0i)))];
let _e3047 = local_4;
let _e3051 = (_e2988 + (3i * ((_e2982 * _e3047) + _e2956)));
let _e3053 = select(_e2995, _e3051, (_e3051 < _e2995));
let _e3058 = global_3.member[bitcast<u32>(select(0i, _e3053, (_e3053 > 0i)))];
let _e3059 = (_e3051 + 1i);
let _e3061 = select(_e2995, _e3059, (_e3059 < _e2995));
let _e3066 = global_3.member[bitcast<u32>(select(0i, _e3061, (_e3061 > 0i)))];
let _e3067 = (_e3051 + 2i);
let _e3069 = select(_e2995, _e3067, (_e3067 < _e2995));
let _e3074 = global_3.member[bitcast<u32>(select(0i, _e3069, (_e3069 > 0i)))];
let _e3075 = local_4;
let _e3079 = (_e2988 + (3i * ((_e2982 * _e3075) + _e2979)));
let _e3081 = select(_e2995, _e3079, (_e3079 < _e2995));
let _e3086 = global_3.member[bitcast<u32>(select(0i, _e3081, (_e3081 > 0i)))];
let _e3087 = (_e3079 + 1i);
let _e3089 = select(_e2995, _e3087, (_e3087 < _e2995));
let _e3094 = global_3.member[bitcast<u32>(select(0i, _e3089, (_e3089 > 0i)))];
let _e3095 = (_e3079 + 2i);
let _e3097 = select(_e2995, _e3095, (_e3095 < _e2995));
let _e3102 = global_3.member[bitcast<u32>(select(0i, _e3097, (_e3097 > 0i)))];
let _e3109 = (_e3002 + ((_e3030 - _e3002) * _e2973));
let _e3110 = (_e3010 + ((_e3038 - _e3010) * _e2973));
let _e3111 = (_e3018 + ((_e3046 - _e3018) * _e2973));
phi_5749_ = vec3<f32>(((_e3109 + (((_e3058 + ((_e3086 - _e3058) * _e2973)) - _e3109) * _e2975)) * _e2901), ((_e3110 + (((_e3066 + ((_e3094 - _e3066) * _e2973)) - _e3110) * _e2975)) * _e2901), ((_e3111 + (((_e3074 + ((_e3102 - _e3074) * _e2973)) - _e3111) * _e2975)) * _e2901));
} else {
phi_5749_ = vec3(_e2901);
}
let _e3136 = phi_5749_;
phi_5752_ = (_e2829 * _e3136);
} else {
phi_5752_ = _e2829;
}
let _e3139 = phi_5752_;
let _e3143 = (1f / sqrt(select(0f, _e2824, (_e2824 > 0f))));
phi_5765_ = type_27(vec3<f32>((_e2813 * _e3143), (_e2815 * _e3143), (_e2817 * _e3143)), _e3139);
}
let _e3150 = phi_5765_;
let _e3161 = -((((_e2779 * _e3150.member.x) + (_e2780 * _e3150.member.y)) + (_e2781 * _e3150.member.z)));
let _e3166 = (((_e2743.member_1.x * _e3150.member.x) + (_e2743.member_1.y * _e3150.member.y)) + (_e2743.member_1.z * _e3150.member.z));
let _e3171 = -(_e3161);
let _e3176 = select((select(0f, _e3171, (_e3171 > 0f)) * _e2743.member_4), select(0f, _e3161, (_e3161 > 0f)), ((_e3166 * _e2752) > 0f));
let _e3177 = -(_e3166);
let _e3178 = -(_e3177);
let _e3180 = select(_e3178, _e3177, (_e3177 > _e3178));
let _e3186 = global_1.member.member_21.member_6;
let _e3200 = ((((_e3186.member.member * _e2743.member.x) + (_e3186.member.member_1 * _e2743.member.y)) + (_e3186.member.member_2 * _e2743.member.z)) + _e3186.member_1);
let _e3202 = select(1f, _e3200, (_e3200 > 1e-6f));
let _e3206 = global_1.member.member_21.member_4;
let _e3218 = (((((_e3206.member.member * _e2743.member.x) + (_e3206.member.member_1 * _e2743.member.y)) + (_e3206.member.member_2 * _e2743.member.z)) + _e3206.member_1) / _e3202);
let _e3222 = global_1.member.member_21.member_5;
let _e3234 = (((((_e3222.member.member * _e2743.member.x) + (_e3222.member.member_1 * _e2743.member.y)) + (_e3222.member.member_2 * _e2743.member.z)) + _e3222.member_1) / _e3202);
let _e3238 = global_1.member.member_21.member_2;
let _e3247 = -((((_e2743.member_1.x * _e3238.member) + (_e2743.member_1.y * _e3238.member_1)) + (_e2743.member_1.z * _e3238.member_2)));
let _e3248 = -(_e3247);
let _e3250 = select(_e3248, _e3247, (_e3247 > _e3248));
let _e3252 = select(1f, _e3250, (_e3250 < 1f));
let _e3254 = (1f - (_e3252 * _e3252));
let _e3261 = global_1.member.member_21.member_8;
let _e3262 = (1.4142135f * _e3261);
let _e3269 = global_1.member.member_21.member_7.member;
let _e3274 = global_1.member.member_21.member_7.member_2;
let _e3276 = (_e3269 + (_e3274 * _e3218));
let _e3281 = global_1.member.member_21.member_7.member_1;
let _e3283 = (_e3281 + (_e3274 * _e3234));
let _e3287 = ((1f + (_e3276 * _e3276)) + (_e3283 * _e3283));
let _e3296 = global_1.member.member_21.member_9;
let _e3300 = (select(1f, -1f, (_e3177 < 0f)) * ((((_e3262 * sqrt(select(0f, _e3254, (_e3254 > 0f)))) * _e3200) + (select(1f, _e3180, (_e3180 < 1f)) * sqrt(select(0f, _e3287, (_e3287 > 0f))))) * _e3296));
let _e3305 = select(0f, 1f, _e2743.member_5);
let _e3309 = (_e2743.member.x + ((_e2743.member_1.x * _e3300) * _e3305));
let _e3310 = (_e2743.member.y + ((_e2743.member_1.y * _e3300) * _e3305));
let _e3311 = (_e2743.member.z + ((_e2743.member_1.z * _e3300) * _e3305));
let _e3315 = global_1.member.member_21.member_11;
let _e3316 = bitcast<i32>(_e3315);
let _e3320 = global_1.member.member_21.member_1;
let _e3321 = bitcast<i32>(_e3320);
let _e3326 = global_1.member.member_21.member.member_1;
let _e3327 = bitcast<i32>(_e3326);
let _e3332 = global_1.member.member_21.member.member_2;
let _e3333 = bitcast<i32>(_e3332);
let _e3339 = ((((_e3186.member.member * _e3309) + (_e3186.member.member_1 * _e3310)) + (_e3186.member.member_2 * _e3311)) + _e3186.member_1);
let _e3341 = select(1f, _e3339, (_e3339 > 1e-6f));
let _e3345 = global_1.member.member_21.member_3;
let _e3356 = ((((_e3345.member.member * _e3309) + (_e3345.member.member_1 * _e3310)) + (_e3345.member.member_2 * _e3311)) + _e3345.member_1);
let _e3371 = ((((((_e3206.member.member * _e3309) + (_e3206.member.member_1 * _e3310)) + (_e3206.member.member_2 * _e3311)) + _e3206.member_1) / _e3341) - 0.5f);
let _e3372 = ((((((_e3222.member.member * _e3309) + (_e3222.member.member_1 * _e3310)) + (_e3222.member.member_2 * _e3311)) + _e3222.member_1) / _e3341) - 0.5f);
let _e3376 = global_1.member.member_21.member_10;
let _e3377 = (_e3376 > 0f);
if (_e3377 && (_e3321 > 0i)) {
let _e3384 = global_1.member.member_21.member.member;
let _e3391 = (_e3376 * select(0f, _e3356, (_e3356 > 0f)));
let _e3392 = (16f - 1f);
let _e3396 = (select(_e3392, _e3391, (_e3391 < _e3392)) * (1f / 3f));
phi_6108_ = -3i;
phi_6111_ = -3i;
phi_6113_ = 0f;
phi_6115_ = 0f;
loop {
let _e3398 = phi_6108_;
let _e3400 = phi_6111_;
let _e3402 = phi_6113_;
let _e3404 = phi_6115_;
local_70 = _e3404;
local_71 = _e3404;
local_72 = _e3404;
local_73 = _e3402;
let _e3405 = (_e3398 <= 3i);
if _e3405 {
let _e3407 = (f32(_e3400) * _e3396);
let _e3409 = (f32(_e3398) * _e3396);
let _e3411 = ((_e3371 + _e3407) + 0.5f);
let _e3412 = f32(_e3327);
let _e3414 = select(-1f, _e3411, (_e3411 > -1f));
let _e3416 = select(_e3412, _e3414, (_e3414 < _e3412));
let _e3423 = select(0i, select(select(i32(_e3416), i32(-2147483648), (_e3416 < -2147483600f)), 2147483647i, (_e3416 > 2147483500f)), (_e3416 == _e3416));
let _e3427 = (_e3423 - select(0i, 1i, (_e3416 < f32(_e3423))));
let _e3429 = ((_e3372 + _e3409) + 0.5f);
let _e3430 = f32(_e3333);
let _e3432 = select(-1f, _e3429, (_e3429 > -1f));
let _e3434 = select(_e3430, _e3432, (_e3432 < _e3430));
let _e3441 = select(0i, select(select(i32(_e3434), i32(-2147483648), (_e3434 < -2147483600f)), 2147483647i, (_e3434 > 2147483500f)), (_e3434 == _e3434));
let _e3445 = (_e3441 - select(0i, 1i, (_e3434 < f32(_e3441))));
let _e3452 = ((((_e3427 >= 0i) && (_e3427 < _e3327)) && (_e3445 >= 0i)) && (_e3445 < _e3333));
if _e3452 {
phi_6191_ = ((_e3445 * _e3327) + _e3427);
} else {
phi_6191_ = 0i;
}
let _e3456 = phi_6191_;
let _e3461 = ((_e3407 * _e3407) + (_e3409 * _e3409));
let _e3465 = (sqrt(select(0f, _e3461, (_e3461 > 0f))) - _e3262);
let _e3468 = (1.2247449f * _e3376);
let _e3473 = (_e3356 - select(0f, (select(0f, _e3465, (_e3465 > 0f)) / select(1e-6f, _e3468, (_e3468 > 1e-6f))), _e3377));
let _e3475 = f32(bitcast<i32>(_e3384));
let _e3476 = (_e3475 - 1f);
let _e3478 = select(0f, _e3473, (_e3473 > 0f));
let _e3480 = select(_e3476, _e3478, (_e3478 < _e3476));
let _e3487 = select(0i, select(select(i32(_e3480), i32(-2147483648), (_e3480 < -2147483600f)), 2147483647i, (_e3480 > 2147483500f)), (_e3480 == _e3480));
let _e3491 = (_e3487 - select(0i, 1i, (_e3480 < f32(_e3487))));
let _e3494 = (_e3473 - f32(_e3491));
let _e3498 = (4i * (_e3316 + (_e3456 * bitcast<i32>(((_e3384 + 2u) >> bitcast<u32>(1i))))));
let _e3500 = (_e3498 + (2i * _e3491));
let _e3502 = (_e3500 >> bitcast<u32>(2i));
let _e3505 = bitcast<u32>(((_e3500 & 3i) * 8i));
let _e3507 = (bitcast<i32>(_e154) - 1i);
let _e3509 = select(_e3507, _e3502, (_e3502 < _e3507));
let _e3515 = global_6.member[bitcast<u32>(select(0i, _e3509, (_e3509 > 0i)))];
let _e3519 = (_e3502 + 1i);
let _e3521 = select(_e3507, _e3519, (_e3519 < _e3507));
let _e3527 = global_6.member[bitcast<u32>(select(0i, _e3521, (_e3521 > 0i)))];
let _e3534 = ((_e3515 >> bitcast<u32>((_e3505 & 31u))) | ((_e3527 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3505) & 31u))));
let _e3537 = f32(bitcast<i32>((_e3534 & 65535u)));
let _e3545 = (1f / 65535f);
let _e3548 = select(0f, (1f - ((_e3537 + ((f32(bitcast<i32>((_e3534 >> bitcast<u32>(16i)))) - _e3537) * select(1f, select(0f, _e3494, (_e3494 > 0f)), (_e3473 < _e3475)))) * _e3545)), _e3452);
if (_e3548 > 1e-4f) {
phi_6340_ = 0i;
phi_6343_ = _e3478;
phi_6345_ = 0f;
loop {
let _e3551 = phi_6340_;
let _e3553 = phi_6343_;
let _e3555 = phi_6345_;
local_69 = _e3553;
let _e3556 = (_e3551 < 10i);
if _e3556 {
let _e3558 = (0.5f * (_e3555 + _e3553));
let _e3560 = select(0f, _e3558, (_e3558 > 0f));
let _e3562 = select(_e3476, _e3560, (_e3560 < _e3476));
let _e3569 = select(0i, select(select(i32(_e3562), i32(-2147483648), (_e3562 < -2147483600f)), 2147483647i, (_e3562 > 2147483500f)), (_e3562 == _e3562));
let _e3573 = (_e3569 - select(0i, 1i, (_e3562 < f32(_e3569))));
let _e3576 = (_e3558 - f32(_e3573));
let _e3581 = (_e3498 + (2i * _e3573));
let _e3583 = (_e3581 >> bitcast<u32>(2i));
let _e3586 = bitcast<u32>(((_e3581 & 3i) * 8i));
let _e3588 = select(_e3507, _e3583, (_e3583 < _e3507));
let _e3594 = global_6.member[bitcast<u32>(select(0i, _e3588, (_e3588 > 0i)))];
let _e3598 = (_e3583 + 1i);
let _e3600 = select(_e3507, _e3598, (_e3598 < _e3507));
let _e3606 = global_6.member[bitcast<u32>(select(0i, _e3600, (_e3600 > 0i)))];
let _e3613 = ((_e3594 >> bitcast<u32>((_e3586 & 31u))) | ((_e3606 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3586) & 31u))));
let _e3616 = f32(bitcast<i32>((_e3613 & 65535u)));
let _e3627 = (((_e3616 + ((f32(bitcast<i32>((_e3613 >> bitcast<u32>(16i)))) - _e3616) * select(1f, select(0f, _e3576, (_e3576 > 0f)), (_e3558 < _e3475)))) * _e3545) > (1f - (0.5f * _e3548)));
phi_6341_ = (_e3551 + 1i);
phi_6344_ = select(_e3558, _e3553, _e3627);
phi_6346_ = select(_e3555, _e3558, _e3627);
} else {
phi_6341_ = i32();
phi_6344_ = f32();
phi_6346_ = f32();
}
let _e3632 = phi_6341_;
let _e3634 = phi_6344_;
let _e3636 = phi_6346_;
continue;
continuing {
phi_6340_ = _e3632;
phi_6343_ = _e3634;
phi_6345_ = _e3636;
break if !(_e3556);
}
}
let _e3640 = local_69;
phi_6466_ = (_e3402 + (_e3548 * _e3640));
phi_6467_ = (_e3404 + _e3548);
} else {
phi_6466_ = _e3402;
phi_6467_ = _e3404;
}
let _e3644 = phi_6466_;
let _e3646 = phi_6467_;
let _e3647 = (_e3400 == 3i);
if _e3647 {
phi_6473_ = -3i;
} else {
phi_6473_ = (_e3400 + 1i);
}
let _e3650 = phi_6473_;
phi_6109_ = (_e3398 + select(0i, 1i, _e3647));
phi_6112_ = _e3650;
phi_6114_ = _e3644;
phi_6116_ = _e3646;
} else {
phi_6109_ = i32();
phi_6112_ = i32();
phi_6114_ = f32();
phi_6116_ = f32();
}
let _e3654 = phi_6109_;
let _e3656 = phi_6112_;
let _e3658 = phi_6114_;
let _e3660 = phi_6116_;
continue;
continuing {
phi_6108_ = _e3654;
phi_6111_ = _e3656;
phi_6113_ = _e3658;
phi_6115_ = _e3660;
break if !(_e3405);
}
}
let _e3663 = local_70;
let _e3666 = local_71;
let _e3669 = local_72;
let _e3672 = local_73;
let _e3674 = (_e3356 - (_e3672 / select(1e-4f, _e3669, (_e3666 > 1e-4f))));
let _e3679 = ((1.2247449f * _e3376) * select(0f, select(0f, _e3674, (_e3674 > 0f)), (_e3663 > 0f)));
let _e3682 = ((_e3261 * _e3261) + (_e3679 * _e3679));
let _e3685 = sqrt(select(0f, _e3682, (_e3682 > 0f)));
phi_6517_ = select(16f, _e3685, (_e3685 < 16f));
} else {
phi_6517_ = _e3261;
}
let _e3689 = phi_6517_;
let _e3690 = (_e3371 - _e3689);
let _e3691 = -(16f);
let _e3692 = f32(_e3327);
let _e3694 = select(_e3691, _e3690, (_e3690 > _e3691));
let _e3696 = select(_e3692, _e3694, (_e3694 < _e3692));
let _e3703 = select(0i, select(select(i32(_e3696), i32(-2147483648), (_e3696 < -2147483600f)), 2147483647i, (_e3696 > 2147483500f)), (_e3696 == _e3696));
let _e3709 = (_e3371 + _e3689);
let _e3712 = (f32((_e3327 - 1i)) + 16f);
let _e3714 = select(-1f, _e3709, (_e3709 > -1f));
let _e3716 = select(_e3712, _e3714, (_e3714 < _e3712));
let _e3723 = select(0i, select(select(i32(_e3716), i32(-2147483648), (_e3716 < -2147483600f)), 2147483647i, (_e3716 > 2147483500f)), (_e3716 == _e3716));
let _e3728 = (_e3372 - _e3689);
let _e3729 = f32(_e3333);
let _e3731 = select(_e3691, _e3728, (_e3728 > _e3691));
let _e3733 = select(_e3729, _e3731, (_e3731 < _e3729));
let _e3740 = select(0i, select(select(i32(_e3733), i32(-2147483648), (_e3733 < -2147483600f)), 2147483647i, (_e3733 > 2147483500f)), (_e3733 == _e3733));
let _e3746 = (_e3372 + _e3689);
let _e3749 = (f32((_e3333 - 1i)) + 16f);
let _e3751 = select(-1f, _e3746, (_e3746 > -1f));
let _e3753 = select(_e3749, _e3751, (_e3751 < _e3749));
let _e3760 = select(0i, select(select(i32(_e3753), i32(-2147483648), (_e3753 < -2147483600f)), 2147483647i, (_e3753 > 2147483500f)), (_e3753 == _e3753));
let _e3769 = global_1.member.member_21.member.member;
let _e3773 = bitcast<i32>(((_e3769 + 2u) >> bitcast<u32>(1i)));
let _e3775 = ((_e3327 * _e3333) * _e3773);
phi_6635_ = 0f;
phi_6638_ = vec3<f32>(0f, 0f, 0f);
phi_6640_ = ((_e3740 - select(0i, 1i, (_e3733 < f32(_e3740)))) + 1i);
loop {
let _e3777 = phi_6635_;
let _e3779 = phi_6638_;
let _e3781 = phi_6640_;
local_74 = _e3777;
local_75 = _e3777;
local_76 = _e3779;
local_77 = _e3779;
local_78 = _e3779;
let _e3782 = (_e3781 <= (_e3760 - select(0i, 1i, (_e3753 < f32(_e3760)))));
if _e3782 {
let _e3784 = (f32(_e3781) - _e3372);
let _e3788 = (_e3689 - bitcast<f32>((bitcast<u32>(_e3784) & 2147483647u)));
phi_6655_ = ((_e3703 - select(0i, 1i, (_e3696 < f32(_e3703)))) + 1i);
phi_6658_ = _e3777;
phi_6660_ = _e3779;
loop {
let _e3790 = phi_6655_;
let _e3792 = phi_6658_;
let _e3794 = phi_6660_;
local_89 = _e3792;
local_90 = _e3794;
let _e3795 = (_e3790 <= (_e3723 - select(0i, 1i, (_e3716 < f32(_e3723)))));
if _e3795 {
let _e3797 = (f32(_e3790) - _e3371);
let _e3801 = (_e3689 - bitcast<f32>((bitcast<u32>(_e3797) & 2147483647u)));
let _e3806 = (select(0f, _e3801, (_e3801 > 0f)) * select(0f, _e3788, (_e3788 > 0f)));
if ((((_e3790 >= 0i) && (_e3790 < _e3327)) && (_e3781 >= 0i)) && (_e3781 < _e3333)) {
let _e3817 = (_e3316 + (((_e3781 * _e3327) + _e3790) * _e3773));
let _e3820 = ((_e3797 * _e3797) + (_e3784 * _e3784));
let _e3824 = (sqrt(select(0f, _e3820, (_e3820 > 0f))) - _e3262);
let _e3827 = (1.2247449f * _e3376);
let _e3832 = (_e3356 - select(0f, (select(0f, _e3824, (_e3824 > 0f)) / select(1e-6f, _e3827, (_e3827 > 1e-6f))), _e3377));
let _e3834 = f32(bitcast<i32>(_e3769));
let _e3835 = (_e3834 - 1f);
let _e3837 = select(0f, _e3832, (_e3832 > 0f));
let _e3839 = select(_e3835, _e3837, (_e3837 < _e3835));
let _e3846 = select(0i, select(select(i32(_e3839), i32(-2147483648), (_e3839 < -2147483600f)), 2147483647i, (_e3839 > 2147483500f)), (_e3839 == _e3839));
let _e3850 = (_e3846 - select(0i, 1i, (_e3839 < f32(_e3846))));
let _e3853 = (_e3832 - f32(_e3850));
let _e3856 = select(1f, select(0f, _e3853, (_e3853 > 0f)), (_e3832 < _e3834));
let _e3858 = (2i * _e3850);
let _e3859 = ((4i * _e3817) + _e3858);
let _e3861 = (_e3859 >> bitcast<u32>(2i));
let _e3864 = bitcast<u32>(((_e3859 & 3i) * 8i));
let _e3866 = (bitcast<i32>(_e154) - 1i);
let _e3868 = select(_e3866, _e3861, (_e3861 < _e3866));
let _e3874 = global_6.member[bitcast<u32>(select(0i, _e3868, (_e3868 > 0i)))];
let _e3878 = (_e3861 + 1i);
let _e3880 = select(_e3866, _e3878, (_e3878 < _e3866));
let _e3886 = global_6.member[bitcast<u32>(select(0i, _e3880, (_e3880 > 0i)))];
let _e3893 = ((_e3874 >> bitcast<u32>((_e3864 & 31u))) | ((_e3886 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3864) & 31u))));
let _e3896 = f32(bitcast<i32>((_e3893 & 65535u)));
let _e3904 = (1f / 65535f);
let _e3906 = (_e3806 * ((_e3896 + ((f32(bitcast<i32>((_e3893 >> bitcast<u32>(16i)))) - _e3896) * _e3856)) * _e3904));
let _e3908 = (_e3794.x + _e3906);
if (_e3321 > 1i) {
let _e3912 = ((4i * (_e3817 + _e3775)) + _e3858);
let _e3914 = (_e3912 >> bitcast<u32>(2i));
let _e3917 = bitcast<u32>(((_e3912 & 3i) * 8i));
let _e3919 = select(_e3866, _e3914, (_e3914 < _e3866));
let _e3925 = global_6.member[bitcast<u32>(select(0i, _e3919, (_e3919 > 0i)))];
let _e3929 = (_e3914 + 1i);
let _e3931 = select(_e3866, _e3929, (_e3929 < _e3866));
let _e3937 = global_6.member[bitcast<u32>(select(0i, _e3931, (_e3931 > 0i)))];
let _e3944 = ((_e3925 >> bitcast<u32>((_e3917 & 31u))) | ((_e3937 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3917) & 31u))));
let _e3947 = f32(bitcast<i32>((_e3944 & 65535u)));
let _e3962 = ((4i * (_e3817 + (2i * _e3775))) + _e3858);
let _e3964 = (_e3962 >> bitcast<u32>(2i));
let _e3967 = bitcast<u32>(((_e3962 & 3i) * 8i));
let _e3969 = select(_e3866, _e3964, (_e3964 < _e3866));
let _e3975 = global_6.member[bitcast<u32>(select(0i, _e3969, (_e3969 > 0i)))];
let _e3979 = (_e3964 + 1i);
let _e3981 = select(_e3866, _e3979, (_e3979 < _e3866));
let _e3987 = global_6.member[bitcast<u32>(select(0i, _e3981, (_e3981 > 0i)))];
let _e3994 = ((_e3975 >> bitcast<u32>((_e3967 & 31u))) | ((_e3987 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3967) & 31u))));
let _e3997 = f32(bitcast<i32>((_e3994 & 65535u)));
phi_7049_ = vec3<f32>(_e3908, (_e3794.y + (_e3806 * ((_e3947 + ((f32(bitcast<i32>((_e3944 >> bitcast<u32>(16i)))) - _e3947) * _e3856)) * _e3904))), (_e3794.z + (_e3806 * ((_e3997 + ((f32(bitcast<i32>((_e3994 >> bitcast<u32>(16i)))) - _e3997) * _e3856)) * _e3904))));
} else {
phi_7049_ = vec3<f32>(_e3908, (_e3794.y + _e3906), (_e3794.z + _e3906));
}
let _e4016 = phi_7049_;
phi_7059_ = _e4016;
} else {
phi_7059_ = vec3<f32>((_e3794.x + _e3806), (_e3794.y + _e3806), (_e3794.z + _e3806));
}
let _e4025 = phi_7059_;
phi_6656_ = (_e3790 + 1i);
phi_6659_ = (_e3792 + _e3806);
phi_6661_ = _e4025;
} else {
phi_6656_ = i32();
phi_6659_ = f32();
phi_6661_ = vec3<f32>();
}
let _e4029 = phi_6656_;
let _e4031 = phi_6659_;
let _e4033 = phi_6661_;
continue;
continuing {
phi_6655_ = _e4029;
phi_6658_ = _e4031;
phi_6660_ = _e4033;
break if !(_e3795);
}
}
let _e5666 = local_89;
phi_6636_ = _e5666;
let _e5669 = local_90;
phi_6639_ = _e5669;
phi_6641_ = (_e3781 + 1i);
} else {
phi_6636_ = f32();
phi_6639_ = vec3<f32>();
phi_6641_ = i32();
}
let _e4037 = phi_6636_;
let _e4039 = phi_6639_;
let _e4041 = phi_6641_;
continue;
continuing {
phi_6635_ = _e4037;
phi_6638_ = _e4039;
phi_6640_ = _e4041;
break if !(_e3782);
}
}
let _e4045 = local_74;
let _e4049 = (((_e3321 == 0i) || (_e4045 <= 0f)) || (_e3339 <= 1e-6f));
let _e4051 = local_75;
let _e4053 = (1f / select(_e4051, 1f, _e4049));
let _e4055 = local_76;
let _e4060 = local_77;
let _e4065 = local_78;
let _e4069 = (select((_e4055.x * _e4053), 1f, _e4049) * _e3176);
let _e4070 = (select((_e4060.y * _e4053), 1f, _e4049) * _e3176);
let _e4071 = (select((_e4065.z * _e4053), 1f, _e4049) * _e3176);
let _e4082 = global_1.member.member_1;
if ((_e4082 & 16u) == 0u) {
phi_8962_ = (_e3150.member_1 * vec3<f32>(_e4069, _e4070, _e4071));
} else {
let _e4088 = global_1.member.member_22.member;
let _e4099 = ((((_e4088.member.member * _e2743.member.x) + (_e4088.member.member_1 * _e2743.member.y)) + (_e4088.member.member_2 * _e2743.member.z)) + _e4088.member_1);
let _e4103 = global_1.member.member_22.member_1;
let _e4114 = ((((_e4103.member.member * _e2743.member.x) + (_e4103.member.member_1 * _e2743.member.y)) + (_e4103.member.member_2 * _e2743.member.z)) + _e4103.member_1);
let _e4118 = global_1.member.member_22.member_2;
let _e4129 = ((((_e4118.member.member * _e2743.member.x) + (_e4118.member.member_1 * _e2743.member.y)) + (_e4118.member.member_2 * _e2743.member.z)) + _e4118.member_1);
let _e4136 = global_1.member.member_22.member_18.member.member;
let _e4137 = bitcast<i32>(_e4136);
let _e4143 = global_1.member.member_22.member_18.member.member_1;
let _e4144 = bitcast<i32>(_e4143);
let _e4148 = global_1.member.member_22.member_3;
let _e4157 = global_1.member.member_22.member_19.member_2;
let _e4159 = select(1f, (_e4129 - _e4157), (_e4148 != 0u));
let _e4162 = (1f / select(1e-12f, _e4159, (_e4159 > 1e-12f)));
let _e4167 = global_1.member.member_22.member_5;
let _e4172 = global_1.member.member_22.member_8;
let _e4173 = (((_e4099 * _e4162) - _e4167) * _e4172);
let _e4178 = global_1.member.member_22.member_6;
let _e4180 = (((_e4114 * _e4162) - _e4178) * _e4172);
let _e4185 = global_1.member.member_22.member_4.member;
let _e4187 = f32(bitcast<i32>(_e4185));
let _e4189 = select(0f, _e4173, (_e4173 > 0f));
let _e4196 = global_1.member.member_22.member_18.member_1;
let _e4199 = ((_e4173 - _e4187) * _e4196);
let _e4204 = global_1.member.member_22.member_18.member_2;
let _e4206 = select(0f, _e4199, (_e4199 > 0f));
let _e4208 = (_e4204 + _e4206);
let _e4213 = (-(_e4173) * _e4196);
let _e4215 = select(0f, _e4213, (_e4213 > 0f));
let _e4217 = (_e4204 + _e4215);
let _e4224 = (((_e4204 + (select(_e4187, _e4189, (_e4189 < _e4187)) * _e4196)) + (((_e4206 * _e4204) / select(1e-12f, _e4208, (_e4208 > 1e-12f))) - ((_e4215 * _e4204) / select(1e-12f, _e4217, (_e4217 > 1e-12f))))) - 0.5f);
let _e4229 = global_1.member.member_22.member_4.member_1;
let _e4231 = f32(bitcast<i32>(_e4229));
let _e4233 = select(0f, _e4180, (_e4180 > 0f));
let _e4238 = ((_e4180 - _e4231) * _e4196);
let _e4240 = select(0f, _e4238, (_e4238 > 0f));
let _e4242 = (_e4204 + _e4240);
let _e4247 = (-(_e4180) * _e4196);
let _e4249 = select(0f, _e4247, (_e4247 > 0f));
let _e4251 = (_e4204 + _e4249);
let _e4258 = (((_e4204 + (select(_e4231, _e4233, (_e4233 < _e4231)) * _e4196)) + (((_e4240 * _e4204) / select(1e-12f, _e4242, (_e4242 > 1e-12f))) - ((_e4249 * _e4204) / select(1e-12f, _e4251, (_e4251 > 1e-12f))))) - 0.5f);
let _e4260 = f32((_e4137 - 2i));
let _e4262 = select(0f, _e4224, (_e4224 > 0f));
let _e4264 = select(_e4260, _e4262, (_e4262 < _e4260));
let _e4271 = select(0i, select(select(i32(_e4264), i32(-2147483648), (_e4264 < -2147483600f)), 2147483647i, (_e4264 > 2147483500f)), (_e4264 == _e4264));
let _e4275 = (_e4271 - select(0i, 1i, (_e4264 < f32(_e4271))));
let _e4277 = f32((_e4144 - 2i));
let _e4279 = select(0f, _e4258, (_e4258 > 0f));
let _e4281 = select(_e4277, _e4279, (_e4279 < _e4277));
let _e4288 = select(0i, select(select(i32(_e4281), i32(-2147483648), (_e4281 < -2147483600f)), 2147483647i, (_e4281 > 2147483500f)), (_e4281 == _e4281));
let _e4292 = (_e4288 - select(0i, 1i, (_e4281 < f32(_e4288))));
let _e4294 = (_e4224 - f32(_e4275));
let _e4296 = select(0f, _e4294, (_e4294 > 0f));
let _e4298 = select(1f, _e4296, (_e4296 < 1f));
let _e4300 = (_e4258 - f32(_e4292));
let _e4302 = select(0f, _e4300, (_e4300 > 0f));
let _e4304 = select(1f, _e4302, (_e4302 < 1f));
if _e2743.member_6 {
let _e4309 = global_1.member.member_22.member_18.member_4;
phi_7420_ = _e4309;
} else {
let _e4314 = global_1.member.member_22.member_18.member_3;
phi_7420_ = _e4314;
}
let _e4316 = phi_7420_;
let _e4320 = ((bitcast<i32>(_e4316) + (_e4292 * _e4137)) + _e4275);
let _e4321 = (_e4137 * _e4144);
let _e4323 = (bitcast<i32>(_e154) - 1i);
let _e4325 = select(_e4323, _e4320, (_e4320 < _e4323));
let _e4331 = global_6.member[bitcast<u32>(select(0i, _e4325, (_e4325 > 0i)))];
let _e4332 = bitcast<f32>(_e4331);
let _e4333 = (_e4320 + 1i);
let _e4335 = select(_e4323, _e4333, (_e4333 < _e4323));
let _e4341 = global_6.member[bitcast<u32>(select(0i, _e4335, (_e4335 > 0i)))];
let _e4345 = (_e4332 + ((bitcast<f32>(_e4341) - _e4332) * _e4298));
let _e4346 = (_e4320 + _e4137);
let _e4348 = select(_e4323, _e4346, (_e4346 < _e4323));
let _e4354 = global_6.member[bitcast<u32>(select(0i, _e4348, (_e4348 > 0i)))];
let _e4355 = bitcast<f32>(_e4354);
let _e4356 = (_e4346 + 1i);
let _e4358 = select(_e4323, _e4356, (_e4356 < _e4323));
let _e4364 = global_6.member[bitcast<u32>(select(0i, _e4358, (_e4358 > 0i)))];
let _e4371 = (_e4345 + (((_e4355 + ((bitcast<f32>(_e4364) - _e4355) * _e4298)) - _e4345) * _e4304));
let _e4372 = (_e4320 + _e4321);
let _e4374 = select(_e4323, _e4372, (_e4372 < _e4323));
let _e4380 = global_6.member[bitcast<u32>(select(0i, _e4374, (_e4374 > 0i)))];
let _e4381 = bitcast<f32>(_e4380);
let _e4382 = (_e4372 + 1i);
let _e4384 = select(_e4323, _e4382, (_e4382 < _e4323));
let _e4390 = global_6.member[bitcast<u32>(select(0i, _e4384, (_e4384 > 0i)))];
let _e4394 = (_e4381 + ((bitcast<f32>(_e4390) - _e4381) * _e4298));
let _e4395 = (_e4372 + _e4137);
let _e4397 = select(_e4323, _e4395, (_e4395 < _e4323));
let _e4403 = global_6.member[bitcast<u32>(select(0i, _e4397, (_e4397 > 0i)))];
let _e4404 = bitcast<f32>(_e4403);
let _e4405 = (_e4395 + 1i);
let _e4407 = select(_e4323, _e4405, (_e4405 < _e4323));
let _e4413 = global_6.member[bitcast<u32>(select(0i, _e4407, (_e4407 > 0i)))];
let _e4420 = (_e4394 + (((_e4404 + ((bitcast<f32>(_e4413) - _e4404) * _e4298)) - _e4394) * _e4304));
let _e4422 = (_e4320 + (2i * _e4321));
let _e4424 = select(_e4323, _e4422, (_e4422 < _e4323));
let _e4430 = global_6.member[bitcast<u32>(select(0i, _e4424, (_e4424 > 0i)))];
let _e4431 = bitcast<f32>(_e4430);
let _e4432 = (_e4422 + 1i);
let _e4434 = select(_e4323, _e4432, (_e4432 < _e4323));
let _e4440 = global_6.member[bitcast<u32>(select(0i, _e4434, (_e4434 > 0i)))];
let _e4444 = (_e4431 + ((bitcast<f32>(_e4440) - _e4431) * _e4298));
let _e4445 = (_e4422 + _e4137);
let _e4447 = select(_e4323, _e4445, (_e4445 < _e4323));
let _e4453 = global_6.member[bitcast<u32>(select(0i, _e4447, (_e4447 > 0i)))];
let _e4454 = bitcast<f32>(_e4453);
let _e4455 = (_e4445 + 1i);
let _e4457 = select(_e4323, _e4455, (_e4455 < _e4323));
let _e4463 = global_6.member[bitcast<u32>(select(0i, _e4457, (_e4457 > 0i)))];
let _e4470 = (_e4444 + (((_e4454 + ((bitcast<f32>(_e4463) - _e4454) * _e4298)) - _e4444) * _e4304));
let _e4472 = (_e4148 == 0u);
if _e4472 {
phi_7788_ = vec3<f32>(_e4371, _e4420, _e4470);
} else {
if _e4472 {
phi_7756_ = 1f;
} else {
let _e4473 = global_1.member.member_22.member_19;
let _e4477 = (_e4099 - _e4473.member);
let _e4478 = (_e4114 - _e4473.member_1);
let _e4479 = (_e4129 - _e4473.member_2);
let _e4484 = global_1.member.member_22.member_20.member;
let _e4492 = (((_e4484.member * _e4477) + (_e4484.member_1 * _e4478)) + (_e4484.member_2 * _e4479));
let _e4496 = (_e4477 - (_e4484.member * _e4492));
let _e4497 = (_e4478 - (_e4484.member_1 * _e4492));
let _e4498 = (_e4479 - (_e4484.member_2 * _e4492));
let _e4503 = (((_e4496 * _e4496) + (_e4497 * _e4497)) + (_e4498 * _e4498));
let _e4514 = global_1.member.member_22.member_20.member_1;
let _e4520 = global_1.member.member_22.member_20.member_2;
let _e4521 = ((_e4514 - (sqrt(select(0f, _e4503, (_e4503 > 0f))) / select(1e-20f, _e4492, (_e4492 > 1e-20f)))) * _e4520);
let _e4523 = select(0f, _e4521, (_e4521 > 0f));
let _e4525 = select(1f, _e4523, (_e4523 < 1f));
phi_7756_ = select(1f, select(0f, ((_e4525 * _e4525) * (3f - (2f * _e4525))), (_e4492 > 0f)), (_e4520 > 0f));
}
let _e4535 = phi_7756_;
let _e4536 = global_1.member.member_22.member_19;
let _e4540 = select(0f, 1f, ((_e4129 - _e4536.member_2) > 0f));
let _e4544 = ((_e4371 * _e4540) + _e4535);
let _e4545 = ((_e4420 * _e4540) + _e4535);
let _e4546 = ((_e4470 * _e4540) + _e4535);
phi_7788_ = vec3<f32>(select(0f, _e4544, (_e4544 > 0f)), select(0f, _e4545, (_e4545 > 0f)), select(0f, _e4546, (_e4546 > 0f)));
}
let _e4555 = phi_7788_;
let _e4559 = global_1.member.member_19.member_3;
let _e4563 = (_e2743.member.x - _e4559.member);
let _e4564 = (_e2743.member.y - _e4559.member_1);
let _e4565 = (_e2743.member.z - _e4559.member_2);
let _e4570 = (((_e4563 * _e4563) + (_e4564 * _e4564)) + (_e4565 * _e4565));
let _e4574 = select((1f / select(1e-12f, _e4570, (_e4570 > 1e-12f))), 1f, _e2795);
let _e4587 = global_1.member.member_21.member_12;
let _e4588 = bitcast<i32>(_e4587);
let _e4592 = global_1.member.member_21.member_13;
let _e4593 = bitcast<i32>(_e4592);
let _e4599 = ((((_e3345.member.member * _e2743.member.x) + (_e3345.member.member_1 * _e2743.member.y)) + (_e3345.member.member_2 * _e2743.member.z)) + _e3345.member_1);
let _e4600 = (_e3218 - 0.5f);
let _e4601 = (_e3234 - 0.5f);
if (_e3377 && (_e4593 > 0i)) {
let _e4606 = (_e3376 * select(0f, _e4599, (_e4599 > 0f)));
let _e4607 = (16f - 1f);
let _e4611 = (select(_e4607, _e4606, (_e4606 < _e4607)) * (1f / 3f));
phi_7960_ = -3i;
phi_7963_ = -3i;
phi_7965_ = 0f;
phi_7967_ = 0f;
loop {
let _e4613 = phi_7960_;
let _e4615 = phi_7963_;
let _e4617 = phi_7965_;
let _e4619 = phi_7967_;
local_80 = _e4619;
local_81 = _e4619;
local_82 = _e4619;
local_83 = _e4617;
let _e4620 = (_e4613 <= 3i);
if _e4620 {
let _e4622 = (f32(_e4615) * _e4611);
let _e4624 = (f32(_e4613) * _e4611);
let _e4626 = ((_e4600 + _e4622) + 0.5f);
let _e4628 = select(-1f, _e4626, (_e4626 > -1f));
let _e4630 = select(_e3692, _e4628, (_e4628 < _e3692));
let _e4637 = select(0i, select(select(i32(_e4630), i32(-2147483648), (_e4630 < -2147483600f)), 2147483647i, (_e4630 > 2147483500f)), (_e4630 == _e4630));
let _e4641 = (_e4637 - select(0i, 1i, (_e4630 < f32(_e4637))));
let _e4643 = ((_e4601 + _e4624) + 0.5f);
let _e4645 = select(-1f, _e4643, (_e4643 > -1f));
let _e4647 = select(_e3729, _e4645, (_e4645 < _e3729));
let _e4654 = select(0i, select(select(i32(_e4647), i32(-2147483648), (_e4647 < -2147483600f)), 2147483647i, (_e4647 > 2147483500f)), (_e4647 == _e4647));
let _e4658 = (_e4654 - select(0i, 1i, (_e4647 < f32(_e4654))));
let _e4665 = ((((_e4641 >= 0i) && (_e4641 < _e3327)) && (_e4658 >= 0i)) && (_e4658 < _e3333));
if _e4665 {
phi_8043_ = ((_e4658 * _e3327) + _e4641);
} else {
phi_8043_ = 0i;
}
let _e4669 = phi_8043_;
let _e4674 = ((_e4622 * _e4622) + (_e4624 * _e4624));
let _e4678 = (sqrt(select(0f, _e4674, (_e4674 > 0f))) - _e3262);
let _e4681 = (1.2247449f * _e3376);
let _e4686 = (_e4599 - select(0f, (select(0f, _e4678, (_e4678 > 0f)) / select(1e-6f, _e4681, (_e4681 > 1e-6f))), _e3377));
let _e4688 = f32(bitcast<i32>(_e3769));
let _e4689 = (_e4688 - 1f);
let _e4691 = select(0f, _e4686, (_e4686 > 0f));
let _e4693 = select(_e4689, _e4691, (_e4691 < _e4689));
let _e4700 = select(0i, select(select(i32(_e4693), i32(-2147483648), (_e4693 < -2147483600f)), 2147483647i, (_e4693 > 2147483500f)), (_e4693 == _e4693));
let _e4704 = (_e4700 - select(0i, 1i, (_e4693 < f32(_e4700))));
let _e4707 = (_e4686 - f32(_e4704));
let _e4711 = (4i * (_e4588 + (_e4669 * _e3773)));
let _e4713 = (_e4711 + (2i * _e4704));
let _e4715 = (_e4713 >> bitcast<u32>(2i));
let _e4718 = bitcast<u32>(((_e4713 & 3i) * 8i));
let _e4720 = select(_e4323, _e4715, (_e4715 < _e4323));
let _e4726 = global_6.member[bitcast<u32>(select(0i, _e4720, (_e4720 > 0i)))];
let _e4730 = (_e4715 + 1i);
let _e4732 = select(_e4323, _e4730, (_e4730 < _e4323));
let _e4738 = global_6.member[bitcast<u32>(select(0i, _e4732, (_e4732 > 0i)))];
let _e4745 = ((_e4726 >> bitcast<u32>((_e4718 & 31u))) | ((_e4738 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4718) & 31u))));
let _e4748 = f32(bitcast<i32>((_e4745 & 65535u)));
let _e4756 = (1f / 65535f);
let _e4759 = select(0f, (1f - ((_e4748 + ((f32(bitcast<i32>((_e4745 >> bitcast<u32>(16i)))) - _e4748) * select(1f, select(0f, _e4707, (_e4707 > 0f)), (_e4686 < _e4688)))) * _e4756)), _e4665);
if (_e4759 > 1e-4f) {
phi_8192_ = 0i;
phi_8195_ = _e4691;
phi_8197_ = 0f;
loop {
let _e4762 = phi_8192_;
let _e4764 = phi_8195_;
let _e4766 = phi_8197_;
local_79 = _e4764;
let _e4767 = (_e4762 < 10i);
if _e4767 {
let _e4769 = (0.5f * (_e4766 + _e4764));
let _e4771 = select(0f, _e4769, (_e4769 > 0f));
let _e4773 = select(_e4689, _e4771, (_e4771 < _e4689));
let _e4780 = select(0i, select(select(i32(_e4773), i32(-2147483648), (_e4773 < -2147483600f)), 2147483647i, (_e4773 > 2147483500f)), (_e4773 == _e4773));
let _e4784 = (_e4780 - select(0i, 1i, (_e4773 < f32(_e4780))));
let _e4787 = (_e4769 - f32(_e4784));
let _e4792 = (_e4711 + (2i * _e4784));
let _e4794 = (_e4792 >> bitcast<u32>(2i));
let _e4797 = bitcast<u32>(((_e4792 & 3i) * 8i));
let _e4799 = select(_e4323, _e4794, (_e4794 < _e4323));
let _e4805 = global_6.member[bitcast<u32>(select(0i, _e4799, (_e4799 > 0i)))];
let _e4809 = (_e4794 + 1i);
let _e4811 = select(_e4323, _e4809, (_e4809 < _e4323));
let _e4817 = global_6.member[bitcast<u32>(select(0i, _e4811, (_e4811 > 0i)))];
let _e4824 = ((_e4805 >> bitcast<u32>((_e4797 & 31u))) | ((_e4817 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4797) & 31u))));
let _e4827 = f32(bitcast<i32>((_e4824 & 65535u)));
let _e4838 = (((_e4827 + ((f32(bitcast<i32>((_e4824 >> bitcast<u32>(16i)))) - _e4827) * select(1f, select(0f, _e4787, (_e4787 > 0f)), (_e4769 < _e4688)))) * _e4756) > (1f - (0.5f * _e4759)));
phi_8193_ = (_e4762 + 1i);
phi_8196_ = select(_e4769, _e4764, _e4838);
phi_8198_ = select(_e4766, _e4769, _e4838);
} else {
phi_8193_ = i32();
phi_8196_ = f32();
phi_8198_ = f32();
}
let _e4843 = phi_8193_;
let _e4845 = phi_8196_;
let _e4847 = phi_8198_;
continue;
continuing {
phi_8192_ = _e4843;
phi_8195_ = _e4845;
phi_8197_ = _e4847;
break if !(_e4767);
}
}
let _e4851 = local_79;
phi_8318_ = (_e4617 + (_e4759 * _e4851));
phi_8319_ = (_e4619 + _e4759);
} else {
phi_8318_ = _e4617;
phi_8319_ = _e4619;
}
let _e4855 = phi_8318_;
let _e4857 = phi_8319_;
let _e4858 = (_e4615 == 3i);
if _e4858 {
phi_8325_ = -3i;
} else {
phi_8325_ = (_e4615 + 1i);
}
let _e4861 = phi_8325_;
phi_7961_ = (_e4613 + select(0i, 1i, _e4858));
phi_7964_ = _e4861;
phi_7966_ = _e4855;
phi_7968_ = _e4857;
} else {
phi_7961_ = i32();
phi_7964_ = i32();
phi_7966_ = f32();
phi_7968_ = f32();
}
let _e4865 = phi_7961_;
let _e4867 = phi_7964_;
let _e4869 = phi_7966_;
let _e4871 = phi_7968_;
continue;
continuing {
phi_7960_ = _e4865;
phi_7963_ = _e4867;
phi_7965_ = _e4869;
phi_7967_ = _e4871;
break if !(_e4620);
}
}
let _e4874 = local_80;
let _e4877 = local_81;
let _e4880 = local_82;
let _e4883 = local_83;
let _e4885 = (_e4599 - (_e4883 / select(1e-4f, _e4880, (_e4877 > 1e-4f))));
let _e4890 = ((1.2247449f * _e3376) * select(0f, select(0f, _e4885, (_e4885 > 0f)), (_e4874 > 0f)));
let _e4893 = ((_e3261 * _e3261) + (_e4890 * _e4890));
let _e4896 = sqrt(select(0f, _e4893, (_e4893 > 0f)));
phi_8369_ = select(16f, _e4896, (_e4896 < 16f));
} else {
phi_8369_ = _e3261;
}
let _e4900 = phi_8369_;
let _e4901 = (_e4600 - _e4900);
let _e4903 = select(_e3691, _e4901, (_e4901 > _e3691));
let _e4905 = select(_e3692, _e4903, (_e4903 < _e3692));
let _e4912 = select(0i, select(select(i32(_e4905), i32(-2147483648), (_e4905 < -2147483600f)), 2147483647i, (_e4905 > 2147483500f)), (_e4905 == _e4905));
let _e4918 = (_e4600 + _e4900);
let _e4920 = select(-1f, _e4918, (_e4918 > -1f));
let _e4922 = select(_e3712, _e4920, (_e4920 < _e3712));
let _e4929 = select(0i, select(select(i32(_e4922), i32(-2147483648), (_e4922 < -2147483600f)), 2147483647i, (_e4922 > 2147483500f)), (_e4922 == _e4922));
let _e4934 = (_e4601 - _e4900);
let _e4936 = select(_e3691, _e4934, (_e4934 > _e3691));
let _e4938 = select(_e3729, _e4936, (_e4936 < _e3729));
let _e4945 = select(0i, select(select(i32(_e4938), i32(-2147483648), (_e4938 < -2147483600f)), 2147483647i, (_e4938 > 2147483500f)), (_e4938 == _e4938));
let _e4951 = (_e4601 + _e4900);
let _e4953 = select(-1f, _e4951, (_e4951 > -1f));
let _e4955 = select(_e3749, _e4953, (_e4953 < _e3749));
let _e4962 = select(0i, select(select(i32(_e4955), i32(-2147483648), (_e4955 < -2147483600f)), 2147483647i, (_e4955 > 2147483500f)), (_e4955 == _e4955));
phi_8487_ = 0f;
phi_8490_ = vec3<f32>(0f, 0f, 0f);
phi_8492_ = ((_e4945 - select(0i, 1i, (_e4938 < f32(_e4945)))) + 1i);
loop {
let _e4968 = phi_8487_;
let _e4970 = phi_8490_;
let _e4972 = phi_8492_;
local_84 = _e4968;
local_85 = _e4968;
local_86 = _e4970;
local_87 = _e4970;
local_88 = _e4970;
let _e4973 = (_e4972 <= (_e4962 - select(0i, 1i, (_e4955 < f32(_e4962)))));
if _e4973 {
let _e4975 = (f32(_e4972) - _e4601);
let _e4979 = (_e4900 - bitcast<f32>((bitcast<u32>(_e4975) & 2147483647u)));
phi_8507_ = ((_e4912 - select(0i, 1i, (_e4905 < f32(_e4912)))) + 1i);
phi_8510_ = _e4968;
phi_8512_ = _e4970;
loop {
let _e4981 = phi_8507_;
let _e4983 = phi_8510_;
let _e4985 = phi_8512_;
local_91 = _e4983;
local_92 = _e4985;
let _e4986 = (_e4981 <= (_e4929 - select(0i, 1i, (_e4922 < f32(_e4929)))));
if _e4986 {
let _e4988 = (f32(_e4981) - _e4600);
let _e4992 = (_e4900 - bitcast<f32>((bitcast<u32>(_e4988) & 2147483647u)));
let _e4997 = (select(0f, _e4992, (_e4992 > 0f)) * select(0f, _e4979, (_e4979 > 0f)));
if ((((_e4981 >= 0i) && (_e4981 < _e3327)) && (_e4972 >= 0i)) && (_e4972 < _e3333)) {
let _e5008 = (_e4588 + (((_e4972 * _e3327) + _e4981) * _e3773));
let _e5011 = ((_e4988 * _e4988) + (_e4975 * _e4975));
let _e5015 = (sqrt(select(0f, _e5011, (_e5011 > 0f))) - _e3262);
let _e5018 = (1.2247449f * _e3376);
let _e5023 = (_e4599 - select(0f, (select(0f, _e5015, (_e5015 > 0f)) / select(1e-6f, _e5018, (_e5018 > 1e-6f))), _e3377));
let _e5025 = f32(bitcast<i32>(_e3769));
let _e5026 = (_e5025 - 1f);
let _e5028 = select(0f, _e5023, (_e5023 > 0f));
let _e5030 = select(_e5026, _e5028, (_e5028 < _e5026));
let _e5037 = select(0i, select(select(i32(_e5030), i32(-2147483648), (_e5030 < -2147483600f)), 2147483647i, (_e5030 > 2147483500f)), (_e5030 == _e5030));
let _e5041 = (_e5037 - select(0i, 1i, (_e5030 < f32(_e5037))));
let _e5044 = (_e5023 - f32(_e5041));
let _e5047 = select(1f, select(0f, _e5044, (_e5044 > 0f)), (_e5023 < _e5025));
let _e5049 = (2i * _e5041);
let _e5050 = ((4i * _e5008) + _e5049);
let _e5052 = (_e5050 >> bitcast<u32>(2i));
let _e5055 = bitcast<u32>(((_e5050 & 3i) * 8i));
let _e5057 = select(_e4323, _e5052, (_e5052 < _e4323));
let _e5063 = global_6.member[bitcast<u32>(select(0i, _e5057, (_e5057 > 0i)))];
let _e5067 = (_e5052 + 1i);
let _e5069 = select(_e4323, _e5067, (_e5067 < _e4323));
let _e5075 = global_6.member[bitcast<u32>(select(0i, _e5069, (_e5069 > 0i)))];
let _e5082 = ((_e5063 >> bitcast<u32>((_e5055 & 31u))) | ((_e5075 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5055) & 31u))));
let _e5085 = f32(bitcast<i32>((_e5082 & 65535u)));
let _e5093 = (1f / 65535f);
let _e5095 = (_e4997 * ((_e5085 + ((f32(bitcast<i32>((_e5082 >> bitcast<u32>(16i)))) - _e5085) * _e5047)) * _e5093));
let _e5097 = (_e4985.x + _e5095);
if (_e4593 > 1i) {
let _e5101 = ((4i * (_e5008 + _e3775)) + _e5049);
let _e5103 = (_e5101 >> bitcast<u32>(2i));
let _e5106 = bitcast<u32>(((_e5101 & 3i) * 8i));
let _e5108 = select(_e4323, _e5103, (_e5103 < _e4323));
let _e5114 = global_6.member[bitcast<u32>(select(0i, _e5108, (_e5108 > 0i)))];
let _e5118 = (_e5103 + 1i);
let _e5120 = select(_e4323, _e5118, (_e5118 < _e4323));
let _e5126 = global_6.member[bitcast<u32>(select(0i, _e5120, (_e5120 > 0i)))];
let _e5133 = ((_e5114 >> bitcast<u32>((_e5106 & 31u))) | ((_e5126 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5106) & 31u))));
let _e5136 = f32(bitcast<i32>((_e5133 & 65535u)));
let _e5151 = ((4i * (_e5008 + (2i * _e3775))) + _e5049);
let _e5153 = (_e5151 >> bitcast<u32>(2i));
let _e5156 = bitcast<u32>(((_e5151 & 3i) * 8i));
let _e5158 = select(_e4323, _e5153, (_e5153 < _e4323));
let _e5164 = global_6.member[bitcast<u32>(select(0i, _e5158, (_e5158 > 0i)))];
let _e5168 = (_e5153 + 1i);
let _e5170 = select(_e4323, _e5168, (_e5168 < _e4323));
let _e5176 = global_6.member[bitcast<u32>(select(0i, _e5170, (_e5170 > 0i)))];
let _e5183 = ((_e5164 >> bitcast<u32>((_e5156 & 31u))) | ((_e5176 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5156) & 31u))));
let _e5186 = f32(bitcast<i32>((_e5183 & 65535u)));
phi_8901_ = vec3<f32>(_e5097, (_e4985.y + (_e4997 * ((_e5136 + ((f32(bitcast<i32>((_e5133 >> bitcast<u32>(16i)))) - _e5136) * _e5047)) * _e5093))), (_e4985.z + (_e4997 * ((_e5186 + ((f32(bitcast<i32>((_e5183 >> bitcast<u32>(16i)))) - _e5186) * _e5047)) * _e5093))));
} else {
phi_8901_ = vec3<f32>(_e5097, (_e4985.y + _e5095), (_e4985.z + _e5095));
}
let _e5205 = phi_8901_;
phi_8911_ = _e5205;
} else {
phi_8911_ = vec3<f32>((_e4985.x + _e4997), (_e4985.y + _e4997), (_e4985.z + _e4997));
}
let _e5214 = phi_8911_;
phi_8508_ = (_e4981 + 1i);
phi_8511_ = (_e4983 + _e4997);
phi_8513_ = _e5214;
} else {
phi_8508_ = i32();
phi_8511_ = f32();
phi_8513_ = vec3<f32>();
}
let _e5218 = phi_8508_;
let _e5220 = phi_8511_;
let _e5222 = phi_8513_;
continue;
continuing {
phi_8507_ = _e5218;
phi_8510_ = _e5220;
phi_8512_ = _e5222;
break if !(_e4986);
}
}
let _e5716 = local_91;
phi_8488_ = _e5716;
let _e5719 = local_92;
phi_8491_ = _e5719;
phi_8493_ = (_e4972 + 1i);
} else {
phi_8488_ = f32();
phi_8491_ = vec3<f32>();
phi_8493_ = i32();
}
let _e5226 = phi_8488_;
let _e5228 = phi_8491_;
let _e5230 = phi_8493_;
continue;
continuing {
phi_8487_ = _e5226;
phi_8490_ = _e5228;
phi_8492_ = _e5230;
break if !(_e4973);
}
}
let _e5234 = local_84;
let _e5238 = (((_e4593 == 0i) || (_e5234 <= 0f)) || (_e3200 <= 1e-6f));
let _e5240 = local_85;
let _e5242 = (1f / select(_e5240, 1f, _e5238));
let _e5244 = local_86;
let _e5249 = local_87;
let _e5254 = local_88;
phi_8962_ = vec3<f32>(select((((_e4555.x * (_e2786.member * _e4574)) * select((_e5244.x * _e5242), 1f, _e5238)) * _e3176), (_e3150.member_1.x * _e4069), _e2743.member_5), select((((_e4555.y * (_e2786.member_1 * _e4574)) * select((_e5249.y * _e5242), 1f, _e5238)) * _e3176), (_e3150.member_1.y * _e4070), _e2743.member_5), select((((_e4555.z * (_e2786.member_2 * _e4574)) * select((_e5254.z * _e5242), 1f, _e5238)) * _e3176), (_e3150.member_1.z * _e4071), _e2743.member_5));
}
let _e5269 = phi_8962_;
let _e5275 = (((_e1153.member * _e2779) + (_e1153.member_1 * _e2780)) + (_e1153.member_2 * _e2781));
let _e5280 = (((_e1165.member * _e2779) + (_e1165.member_1 * _e2780)) + (_e1165.member_2 * _e2781));
let _e5285 = (((_e1177.member * _e2779) + (_e1177.member_1 * _e2780)) + (_e1177.member_2 * _e2781));
let _e5289 = global_1.member.member_20.member_1;
let _e5299 = global_1.member.member_20.member_2;
let _e5312 = global_1.member.member_20.member_3;
let _e5325 = global_1.member.member_20.member_4;
let _e5329 = (_e5275 * _e5275);
let _e5336 = global_1.member.member_20.member_5;
let _e5340 = (_e5280 * _e5280);
let _e5350 = global_1.member.member_20.member_6;
let _e5354 = (_e5285 * _e5285);
let _e5364 = global_1.member.member_20.member_7;
let _e5368 = (_e5275 * _e5280);
let _e5375 = global_1.member.member_20.member_8;
let _e5379 = (_e5275 * _e5285);
let _e5389 = global_1.member.member_20.member_9;
let _e5393 = (_e5280 * _e5285);
let _e5403 = global_1.member.member_20.member;
let _e5413 = ((_e5403.member + (((_e5289.member * _e5275) + (_e5299.member * _e5280)) + (_e5312.member * _e5285))) + ((((_e5325.member * _e5329) + (_e5336.member * _e5340)) + (_e5350.member * _e5354)) + (((_e5364.member * _e5368) + (_e5375.member * _e5379)) + (_e5389.member * _e5393))));
let _e5414 = ((_e5403.member_1 + (((_e5289.member_1 * _e5275) + (_e5299.member_1 * _e5280)) + (_e5312.member_1 * _e5285))) + ((((_e5325.member_1 * _e5329) + (_e5336.member_1 * _e5340)) + (_e5350.member_1 * _e5354)) + (((_e5364.member_1 * _e5368) + (_e5375.member_1 * _e5379)) + (_e5389.member_1 * _e5393))));
let _e5415 = ((_e5403.member_2 + (((_e5289.member_2 * _e5275) + (_e5299.member_2 * _e5280)) + (_e5312.member_2 * _e5285))) + ((((_e5325.member_2 * _e5329) + (_e5336.member_2 * _e5340)) + (_e5350.member_2 * _e5354)) + (((_e5364.member_2 * _e5368) + (_e5375.member_2 * _e5379)) + (_e5389.member_2 * _e5393))));
phi_9159_ = (_e2743.member_3 * vec3<f32>((_e5269.x + select(0f, _e5413, (_e5413 > 0f))), (_e5269.y + select(0f, _e5414, (_e5414 > 0f))), (_e5269.z + select(0f, _e5415, (_e5415 > 0f)))));
} else {
phi_9159_ = _e2214;
}
let _e5431 = phi_9159_;
let _e5432 = local_7;
local_2 = _e5432;
local_3 = _e378;
let _e5433 = local_3;
let _e5435 = local_2;
let _e5436 = ((22i * _e5433) + _e5435);
let _e5438 = select(_e384, _e5436, (_e5436 < _e384));
let _e5443 = global_2.member[bitcast<u32>(select(0i, _e5438, (_e5438 > 0i)))];
let _e5444 = local_3;
let _e5446 = local_2;
let _e5447 = ((23i * _e5444) + _e5446);
let _e5449 = select(_e384, _e5447, (_e5447 < _e384));
let _e5454 = global_2.member[bitcast<u32>(select(0i, _e5449, (_e5449 > 0i)))];
let _e5455 = local_3;
let _e5457 = local_2;
let _e5458 = ((24i * _e5455) + _e5457);
let _e5460 = select(_e384, _e5458, (_e5458 < _e384));
let _e5465 = global_2.member[bitcast<u32>(select(0i, _e5460, (_e5460 > 0i)))];
let _e5468 = global_1.member.member_17;
let _e5475 = local_7;
local = _e5475;
local_1 = _e378;
let _e5476 = local_1;
let _e5478 = local;
let _e5479 = ((6i * _e5476) + _e5478);
let _e5481 = select(_e384, _e5479, (_e5479 < _e384));
let _e5486 = global_2.member[bitcast<u32>(select(0i, _e5481, (_e5481 > 0i)))];
let _e5487 = local_1;
let _e5489 = local;
let _e5490 = ((7i * _e5487) + _e5489);
let _e5492 = select(_e384, _e5490, (_e5490 < _e384));
let _e5497 = global_2.member[bitcast<u32>(select(0i, _e5492, (_e5492 > 0i)))];
let _e5498 = local_1;
let _e5500 = local;
let _e5501 = ((8i * _e5498) + _e5500);
let _e5503 = select(_e384, _e5501, (_e5501 < _e384));
let _e5508 = global_2.member[bitcast<u32>(select(0i, _e5503, (_e5503 > 0i)))];
global_7.member[_e168] = (_e179 + ((_e5431.x * _e5486) + (_e5443 * _e5468.member)));
global_7.member[_e180] = (_e189 + ((_e5431.y * _e5497) + (_e5454 * _e5468.member_1)));
global_7.member[_e191] = (_e200 + ((_e5431.z * _e5508) + (_e5465 * _e5468.member_2)));
global_7.member[_e202] = _e211;
global_7.member[_e213] = _e222;
global_7.member[_e224] = _e233;
global_7.member[_e235] = _e244;
global_7.member[_e246] = _e255;
global_7.member[_e257] = _e266;
global_7.member[_e268] = _e277;
global_7.member[_e279] = _e288;
global_7.member[_e290] = _e299;
global_7.member[_e301] = _e310;
global_7.member[_e312] = _e321;
global_7.member[_e323] = _e332;
global_7.member[_e334] = _e343;
global_7.member[_e345] = _e354;
global_7.member[_e356] = _e365;
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
