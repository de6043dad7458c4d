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
struct type_11 {
member: array<f32>,
}
struct type_14 {
member: u32,
member_1: u32,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: vec3<f32>,
member_1: f32,
}
struct type_18 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_21 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_14,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_24 {
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
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: f32,
}
struct type_25 {
member: type_7,
member_1: u32,
}
struct type_26 {
member: type_2,
member_1: u32,
member_2: type_18,
member_3: type_14,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: type_24,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_25,
member_15: type_25,
member_16: type_25,
member_17: type_25,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_27 {
member: type_26,
}
var<private> global: vec3<u32>;
@group(0) @binding(4)
var<storage, read_write> global_1: type_11;
@group(0) @binding(0)
var<storage> global_2: type_27;
@group(0) @binding(2)
var<storage> global_3: type_11;
@group(0) @binding(1)
var<storage> global_4: type_16;
@group(0) @binding(3)
var<storage> global_5: type_16;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var phi_1635_: u32;
var phi_1636_: u32;
var phi_281_: u32;
var phi_282_: u32;
var phi_1383_: i32;
var phi_1553_: vec3<f32>;
var phi_1597_: i32;
var phi_1744_: type_17;
let _e56 = global;
let _e61 = arrayLength((&global_3.member));
let _e66 = global_2.member.member_2;
let _e69 = global_2.member.member;
let _e76 = (_e56.x + _e66.member);
let _e78 = (_e56.y + _e66.member_1);
if (_e76 < _e66.member_2) {
if (_e78 < _e66.member_3) {
let _e87 = global_2.member.member.member;
let _e89 = ((_e78 * _e87) + _e76);
let _e90 = (_e89 / 81u);
let _e92 = (_e89 - (_e90 * 81u));
let _e93 = (_e92 / 9u);
let _e97 = global_2.member.member_10.member_16;
let _e99 = bitcast<i32>((_e97 + _e90));
let _e101 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e103 = select(_e101, _e99, (_e99 < _e101));
let _e109 = global_5.member[bitcast<u32>(select(0i, _e103, (_e103 > 0i)))];
let _e119 = ((bitcast<i32>((_e109 & 65535u)) * 8i) + bitcast<i32>((_e92 - (_e93 * 9u))));
let _e122 = ((bitcast<i32>((_e109 >> bitcast<u32>(16i))) * 8i) + bitcast<i32>(_e93));
let _e124 = (_e69.member_2 == 5u);
if ((((_e69.member_2 == 1u) || _e124) || (_e69.member_2 == 6u)) || ((_e69.member_2 == 2u) || (_e69.member_2 == 7u))) {
let _e231 = global_2.member.member_10.member_4.member;
let _e241 = global_2.member.member_10.member_4.member_1;
let _e244 = ((((_e119 >= 0i) && (_e119 < bitcast<i32>(_e231))) && (_e122 >= 0i)) && (_e122 < bitcast<i32>(_e241)));
if _e244 {
phi_281_ = bitcast<u32>(_e122);
phi_282_ = bitcast<u32>(_e119);
} else {
phi_281_ = 0u;
phi_282_ = 0u;
}
let _e248 = phi_281_;
let _e250 = phi_282_;
let _e251 = (_e231 + 1u);
let _e254 = bitcast<i32>((_e251 * (_e241 + 1u)));
local_6 = _e254;
let _e255 = (_e248 * _e251);
local_7 = bitcast<i32>((_e255 + _e250));
let _e258 = local_7;
let _e260 = (bitcast<i32>(_e61) - 1i);
let _e262 = select(_e260, _e258, (_e258 < _e260));
let _e267 = global_3.member[bitcast<u32>(select(0i, _e262, (_e262 > 0i)))];
let _e268 = local_6;
let _e269 = local_7;
let _e270 = (_e268 + _e269);
let _e272 = select(_e260, _e270, (_e270 < _e260));
let _e277 = global_3.member[bitcast<u32>(select(0i, _e272, (_e272 > 0i)))];
let _e278 = local_6;
let _e280 = local_7;
let _e281 = ((2i * _e278) + _e280);
let _e283 = select(_e260, _e281, (_e281 < _e260));
let _e288 = global_3.member[bitcast<u32>(select(0i, _e283, (_e283 > 0i)))];
let _e289 = local_6;
let _e291 = local_7;
let _e292 = ((3i * _e289) + _e291);
let _e294 = select(_e260, _e292, (_e292 < _e260));
let _e299 = global_3.member[bitcast<u32>(select(0i, _e294, (_e294 > 0i)))];
let _e300 = local_6;
let _e302 = local_7;
let _e303 = ((4i * _e300) + _e302);
let _e305 = select(_e260, _e303, (_e303 < _e260));
let _e310 = global_3.member[bitcast<u32>(select(0i, _e305, (_e305 > 0i)))];
let _e311 = local_6;
let _e313 = local_7;
let _e314 = ((5i * _e311) + _e313);
let _e316 = select(_e260, _e314, (_e314 < _e260));
let _e321 = global_3.member[bitcast<u32>(select(0i, _e316, (_e316 > 0i)))];
let _e322 = local_6;
let _e324 = local_7;
let _e325 = ((6i * _e322) + _e324);
let _e327 = select(_e260, _e325, (_e325 < _e260));
let _e332 = global_3.member[bitcast<u32>(select(0i, _e327, (_e327 > 0i)))];
let _e333 = local_6;
let _e335 = local_7;
let _e336 = ((7i * _e333) + _e335);
let _e338 = select(_e260, _e336, (_e336 < _e260));
let _e343 = global_3.member[bitcast<u32>(select(0i, _e338, (_e338 > 0i)))];
let _e344 = (_e250 + 1u);
local_4 = _e254;
local_5 = bitcast<i32>((_e255 + _e344));
let _e347 = local_5;
let _e349 = select(_e260, _e347, (_e347 < _e260));
let _e354 = global_3.member[bitcast<u32>(select(0i, _e349, (_e349 > 0i)))];
let _e355 = local_4;
let _e356 = local_5;
let _e357 = (_e355 + _e356);
let _e359 = select(_e260, _e357, (_e357 < _e260));
let _e364 = global_3.member[bitcast<u32>(select(0i, _e359, (_e359 > 0i)))];
let _e365 = local_4;
let _e367 = local_5;
let _e368 = ((2i * _e365) + _e367);
let _e370 = select(_e260, _e368, (_e368 < _e260));
let _e375 = global_3.member[bitcast<u32>(select(0i, _e370, (_e370 > 0i)))];
let _e376 = local_4;
let _e378 = local_5;
let _e379 = ((3i * _e376) + _e378);
let _e381 = select(_e260, _e379, (_e379 < _e260));
let _e386 = global_3.member[bitcast<u32>(select(0i, _e381, (_e381 > 0i)))];
let _e387 = local_4;
let _e389 = local_5;
let _e390 = ((4i * _e387) + _e389);
let _e392 = select(_e260, _e390, (_e390 < _e260));
let _e397 = global_3.member[bitcast<u32>(select(0i, _e392, (_e392 > 0i)))];
let _e398 = local_4;
let _e400 = local_5;
let _e401 = ((5i * _e398) + _e400);
let _e403 = select(_e260, _e401, (_e401 < _e260));
let _e408 = global_3.member[bitcast<u32>(select(0i, _e403, (_e403 > 0i)))];
let _e409 = local_4;
let _e411 = local_5;
let _e412 = ((6i * _e409) + _e411);
let _e414 = select(_e260, _e412, (_e412 < _e260));
let _e419 = global_3.member[bitcast<u32>(select(0i, _e414, (_e414 > 0i)))];
let _e420 = local_4;
let _e422 = local_5;
let _e423 = ((7i * _e420) + _e422);
let _e425 = select(_e260, _e423, (_e423 < _e260));
let _e430 = global_3.member[bitcast<u32>(select(0i, _e425, (_e425 > 0i)))];
local_2 = _e254;
let _e432 = ((_e248 + 1u) * _e251);
local_3 = bitcast<i32>((_e432 + _e250));
let _e435 = local_3;
let _e437 = select(_e260, _e435, (_e435 < _e260));
let _e442 = global_3.member[bitcast<u32>(select(0i, _e437, (_e437 > 0i)))];
let _e443 = local_2;
let _e444 = local_3;
let _e445 = (_e443 + _e444);
let _e447 = select(_e260, _e445, (_e445 < _e260));
let _e452 = global_3.member[bitcast<u32>(select(0i, _e447, (_e447 > 0i)))];
let _e453 = local_2;
let _e455 = local_3;
let _e456 = ((2i * _e453) + _e455);
let _e458 = select(_e260, _e456, (_e456 < _e260));
let _e463 = global_3.member[bitcast<u32>(select(0i, _e458, (_e458 > 0i)))];
let _e464 = local_2;
let _e466 = local_3;
let _e467 = ((3i * _e464) + _e466);
let _e469 = select(_e260, _e467, (_e467 < _e260));
let _e474 = global_3.member[bitcast<u32>(select(0i, _e469, (_e469 > 0i)))];
let _e475 = local_2;
let _e477 = local_3;
let _e478 = ((4i * _e475) + _e477);
let _e480 = select(_e260, _e478, (_e478 < _e260));
let _e485 = global_3.member[bitcast<u32>(select(0i, _e480, (_e480 > 0i)))];
let _e486 = local_2;
let _e488 = local_3;
let _e489 = ((5i * _e486) + _e488);
let _e491 = select(_e260, _e489, (_e489 < _e260));
let _e496 = global_3.member[bitcast<u32>(select(0i, _e491, (_e491 > 0i)))];
let _e497 = local_2;
let _e499 = local_3;
let _e500 = ((6i * _e497) + _e499);
let _e502 = select(_e260, _e500, (_e500 < _e260));
let _e507 = global_3.member[bitcast<u32>(select(0i, _e502, (_e502 > 0i)))];
let _e508 = local_2;
let _e510 = local_3;
let _e511 = ((7i * _e508) + _e510);
let _e513 = select(_e260, _e511, (_e511 < _e260));
let _e518 = global_3.member[bitcast<u32>(select(0i, _e513, (_e513 > 0i)))];
local = _e254;
local_1 = bitcast<i32>((_e432 + _e344));
let _e521 = local_1;
let _e523 = select(_e260, _e521, (_e521 < _e260));
let _e528 = global_3.member[bitcast<u32>(select(0i, _e523, (_e523 > 0i)))];
let _e529 = local;
let _e530 = local_1;
let _e531 = (_e529 + _e530);
let _e533 = select(_e260, _e531, (_e531 < _e260));
let _e538 = global_3.member[bitcast<u32>(select(0i, _e533, (_e533 > 0i)))];
let _e539 = local;
let _e541 = local_1;
let _e542 = ((2i * _e539) + _e541);
let _e544 = select(_e260, _e542, (_e542 < _e260));
let _e549 = global_3.member[bitcast<u32>(select(0i, _e544, (_e544 > 0i)))];
let _e550 = local;
let _e552 = local_1;
let _e553 = ((3i * _e550) + _e552);
let _e555 = select(_e260, _e553, (_e553 < _e260));
let _e560 = global_3.member[bitcast<u32>(select(0i, _e555, (_e555 > 0i)))];
let _e561 = local;
let _e563 = local_1;
let _e564 = ((4i * _e561) + _e563);
let _e566 = select(_e260, _e564, (_e564 < _e260));
let _e571 = global_3.member[bitcast<u32>(select(0i, _e566, (_e566 > 0i)))];
let _e572 = local;
let _e574 = local_1;
let _e575 = ((5i * _e572) + _e574);
let _e577 = select(_e260, _e575, (_e575 < _e260));
let _e582 = global_3.member[bitcast<u32>(select(0i, _e577, (_e577 > 0i)))];
let _e583 = local;
let _e585 = local_1;
let _e586 = ((6i * _e583) + _e585);
let _e588 = select(_e260, _e586, (_e586 < _e260));
let _e593 = global_3.member[bitcast<u32>(select(0i, _e588, (_e588 > 0i)))];
let _e594 = local;
let _e596 = local_1;
let _e597 = ((7i * _e594) + _e596);
let _e599 = select(_e260, _e597, (_e597 < _e260));
let _e604 = global_3.member[bitcast<u32>(select(0i, _e599, (_e599 > 0i)))];
let _e619 = (0.5f * bitcast<f32>((bitcast<u32>((((_e528 - _e267) * (_e452 - _e364)) - ((_e538 - _e277) * (_e442 - _e354)))) & 2147483647u)));
let _e625 = (f32(bitcast<i32>(_e250)) - 0.5f);
let _e628 = (f32(bitcast<i32>(_e248)) - 0.5f);
let _e642 = (_e625 + 1f);
let _e657 = (_e628 + 1f);
let _e689 = select(0f, (0.25f / select(select(0.25f, _e619, (_e619 > 0.25f)), 1f, (((_e343 + _e430) + (_e518 + _e604)) == 0f))), (((((((bitcast<f32>((bitcast<u32>((_e267 - _e625)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e277 - _e628)) & 2147483647u)) < 0.5f)) && (_e343 != 2f)) && (((bitcast<f32>((bitcast<u32>((_e354 - _e642)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e364 - _e628)) & 2147483647u)) < 0.5f)) && (_e430 != 2f))) && (((bitcast<f32>((bitcast<u32>((_e442 - _e625)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e452 - _e657)) & 2147483647u)) < 0.5f)) && (_e518 != 2f))) && (((bitcast<f32>((bitcast<u32>((_e528 - _e642)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e538 - _e657)) & 2147483647u)) < 0.5f)) && (_e604 != 2f))) && (_e619 >= 0.5f)));
let _e690 = select(0f, _e689, _e244);
let _e703 = select(1f, (((_e288 + _e375) + (_e463 + _e549)) * _e689), _e244);
let _e704 = select(1f, (((_e299 + _e386) + (_e474 + _e560)) * _e689), _e244);
let _e705 = select(1f, (((_e310 + _e397) + (_e485 + _e571)) * _e689), _e244);
let _e709 = (1f / 3f);
let _e710 = (((_e288 + _e299) + _e310) * _e709);
let _e715 = (((_e375 + _e386) + _e397) * _e709);
let _e722 = (((_e463 + _e474) + _e485) * _e709);
let _e727 = (((_e549 + _e560) + _e571) * _e709);
let _e739 = global_2.member.member_10.member_15;
let _e740 = bitcast<i32>(_e739);
let _e742 = (firstTrailingBit(8u) & 31u);
let _e744 = (_e119 >> bitcast<u32>(_e742));
let _e746 = (_e122 >> bitcast<u32>(_e742));
let _e751 = global_2.member.member_10.member_14.member;
let _e752 = bitcast<i32>(_e751);
let _e757 = global_2.member.member_10.member_14.member_1;
let _e758 = bitcast<i32>(_e757);
let _e763 = global_2.member.member_10.member_14.member_2;
if ((((((_e744 >= 0i) && (_e744 < _e752)) && (_e746 >= 0i)) && (_e746 < _e758)) && (_e740 >= 0i)) && (_e740 < bitcast<i32>(_e763))) {
phi_1383_ = (((((_e740 * _e758) + _e746) * _e752) + _e744) * 3i);
} else {
phi_1383_ = -1i;
}
let _e782 = phi_1383_;
let _e783 = (_e782 + 2i);
let _e785 = select(_e101, _e783, (_e783 < _e101));
let _e791 = global_5.member[bitcast<u32>(select(0i, _e785, (_e785 > 0i)))];
let _e792 = bitcast<i32>(_e791);
let _e803 = select(((((_e792 - 1i) * 64i) + ((_e122 & 7i) * 8i)) + (_e119 & 7i)), -1i, ((_e782 < 0i) || (_e792 == 0i)));
let _e804 = (_e803 * 6i);
let _e810 = global_2.member.member_10.member_20;
let _e811 = (select(0f, 1f, (_e803 >= 0i)) / _e810);
let _e813 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e815 = select(_e813, _e804, (_e804 < _e813));
let _e821 = global_4.member[bitcast<u32>(select(0i, _e815, (_e815 > 0i)))];
let _e822 = bitcast<i32>(_e821);
let _e823 = (_e804 + 1i);
let _e825 = select(_e813, _e823, (_e823 < _e813));
let _e831 = global_4.member[bitcast<u32>(select(0i, _e825, (_e825 > 0i)))];
let _e836 = f32(_e822);
let _e838 = (_e804 + 2i);
let _e840 = select(_e813, _e838, (_e838 < _e813));
let _e846 = global_4.member[bitcast<u32>(select(0i, _e840, (_e840 > 0i)))];
let _e847 = bitcast<i32>(_e846);
let _e848 = (_e804 + 3i);
let _e850 = select(_e813, _e848, (_e848 < _e813));
let _e856 = global_4.member[bitcast<u32>(select(0i, _e850, (_e850 > 0i)))];
if (((_e69.member_2 == 3u) || (_e69.member_2 == 4u)) || _e124) {
phi_1553_ = vec3(_e836);
} else {
let _e867 = (_e804 + 4i);
let _e869 = select(_e813, _e867, (_e867 < _e813));
let _e875 = global_4.member[bitcast<u32>(select(0i, _e869, (_e869 > 0i)))];
phi_1553_ = vec3<f32>(_e836, f32((bitcast<i32>(_e831) - (_e822 >> bitcast<u32>(31i)))), f32(bitcast<i32>(_e875)));
}
let _e881 = phi_1553_;
let _e883 = (_e881.x * _e811);
let _e885 = (_e881.y * _e811);
let _e887 = (_e881.z * _e811);
let _e895 = ((((_e703 + _e883) + (_e704 + _e885)) + (_e705 + _e887)) * _e709);
let _e896 = (_e895 > 1e-4f);
let _e899 = select(0f, (1f / select(1e-4f, _e895, _e896)), _e896);
let _e902 = ((((((_e321 * _e710) + (_e408 * _e715)) + ((_e496 * _e722) + (_e582 * _e727))) * _e690) + (f32(_e847) * _e811)) * _e899);
let _e905 = ((((((_e332 * _e710) + (_e419 * _e715)) + ((_e507 * _e722) + (_e593 * _e727))) * _e690) + (f32((bitcast<i32>(_e856) - (_e847 >> bitcast<u32>(31i)))) * _e811)) * _e899);
if (_e902 < 0f) {
let _e933 = ((bitcast<f32>((bitcast<u32>(_e902) & 2147483647u)) * 16255f) + 0.5f);
let _e934 = (2f * 16255f);
let _e936 = select(0f, _e933, (_e933 > 0f));
let _e938 = select(_e934, _e936, (_e936 < _e934));
let _e945 = select(0i, select(select(i32(_e938), i32(-2147483648), (_e938 < -2147483600f)), 2147483647i, (_e938 > 2147483500f)), (_e938 == _e938));
phi_1597_ = (32768i - (_e945 - select(0i, 1i, (_e938 < f32(_e945)))));
} else {
let _e911 = ((bitcast<f32>((bitcast<u32>(_e902) & 2147483647u)) * 16255f) + 0.5f);
let _e912 = (2f * 16255f);
let _e914 = select(0f, _e911, (_e911 > 0f));
let _e916 = select(_e912, _e914, (_e914 < _e912));
let _e923 = select(0i, select(select(i32(_e916), i32(-2147483648), (_e916 < -2147483600f)), 2147483647i, (_e916 > 2147483500f)), (_e916 == _e916));
phi_1597_ = (32768i + (_e923 - select(0i, 1i, (_e916 < f32(_e923)))));
}
let _e952 = phi_1597_;
let _e959 = ((bitcast<f32>((bitcast<u32>(_e905) & 2147483647u)) * 16255f) + 0.5f);
let _e960 = (2f * 16255f);
let _e962 = select(0f, _e959, (_e959 > 0f));
let _e964 = select(_e960, _e962, (_e962 < _e960));
let _e971 = select(0i, select(select(i32(_e964), i32(-2147483648), (_e964 < -2147483600f)), 2147483647i, (_e964 > 2147483500f)), (_e964 == _e964));
phi_1744_ = type_17((vec3<f32>(_e703, _e704, _e705) + vec3<f32>(_e883, _e885, _e887)), bitcast<f32>(((select(0u, 2147483648u, (_e905 < 0f)) | (bitcast<u32>(((_e971 - select(0i, 1i, (_e964 < f32(_e971)))) + 128i)) << bitcast<u32>(16i))) | bitcast<u32>(_e952))));
} else {
let _e137 = global_2.member.member_10.member_4.member;
let _e147 = global_2.member.member_10.member_4.member_1;
let _e150 = ((((_e119 >= 0i) && (_e119 <= bitcast<i32>(_e137))) && (_e122 >= 0i)) && (_e122 <= bitcast<i32>(_e147)));
if _e150 {
phi_1635_ = bitcast<u32>(_e122);
phi_1636_ = bitcast<u32>(_e119);
} else {
phi_1635_ = 0u;
phi_1636_ = 0u;
}
let _e154 = phi_1635_;
let _e156 = phi_1636_;
let _e157 = (_e137 + 1u);
let _e160 = bitcast<i32>((_e157 * (_e147 + 1u)));
let _e165 = ((6i * _e160) + bitcast<i32>(((_e154 * _e157) + _e156)));
let _e167 = (bitcast<i32>(_e61) - 1i);
let _e169 = select(_e167, _e165, (_e165 < _e167));
let _e175 = global_3.member[bitcast<u32>(select(0i, _e169, (_e169 > 0i)))];
let _e176 = (_e165 + _e160);
let _e178 = select(_e167, _e176, (_e176 < _e167));
let _e184 = global_3.member[bitcast<u32>(select(0i, _e178, (_e178 > 0i)))];
let _e186 = (_e165 + (2i * _e160));
let _e188 = select(_e167, _e186, (_e186 < _e167));
let _e194 = global_3.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e200 = ((0f * 16255f) + 0.5f);
let _e201 = (2f * 16255f);
let _e203 = select(0f, _e200, (_e200 > 0f));
let _e205 = select(_e201, _e203, (_e203 < _e201));
let _e212 = select(0i, select(select(i32(_e205), i32(-2147483648), (_e205 < -2147483600f)), 2147483647i, (_e205 > 2147483500f)), (_e205 == _e205));
let _e216 = (_e212 - select(0i, 1i, (_e205 < f32(_e212))));
phi_1744_ = type_17(vec3<f32>(select(1f, _e175, _e150), select(1f, _e184, _e150), select(1f, _e194, _e150)), bitcast<f32>(((bitcast<u32>((_e216 + 128i)) << bitcast<u32>(16i)) | bitcast<u32>((32768i + _e216)))));
}
let _e986 = phi_1744_;
global_1.member[((_e78 * _e69.member) + _e76)] = _e986.member.x;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
