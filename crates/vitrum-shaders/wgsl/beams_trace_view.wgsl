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
struct type_13 {
member: array<f32>,
}
struct type_17 {
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
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
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
struct type_20 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
}
struct type_21 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
}
struct type_22 {
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
struct type_23 {
member: type_2,
member_1: type_18,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_19,
member_12: type_20,
member_13: type_21,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_22,
}
struct type_24 {
member: type_23,
}
struct type_25 {
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
struct type_26 {
member: i32,
member_1: i32,
member_2: f32,
member_3: f32,
member_4: f32,
}
struct type_29 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(1)
var<storage> global_1: type_13;
@group(0) @binding(2)
var<storage> global_2: type_13;
@group(0) @binding(3)
var<storage> global_3: type_13;
@group(0) @binding(4)
var<storage, read_write> global_4: type_13;
@group(0) @binding(0)
var<storage> global_5: type_24;
@group(0) @binding(5)
var<storage, read_write> global_6: type_29;
fn function_() {
var phi_2378_: f32;
var phi_2405_: type_25;
var phi_2406_: type_25;
var phi_2426_: type_25;
var phi_2428_: type_25;
var phi_2431_: i32;
var phi_2433_: bool;
var phi_3774_: i32;
var phi_3777_: i32;
var phi_3775_: i32;
var phi_3778_: i32;
var local: i32;
var phi_3896_: i32;
var phi_3899_: i32;
var phi_3897_: i32;
var phi_3900_: i32;
var local_1: i32;
var phi_4585_: f32;
var phi_4299_: f32;
var phi_4589_: type_25;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var phi_6581_: f32;
var phi_6582_: f32;
var phi_6815_: f32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var phi_7619_: type_25;
var phi_7629_: type_25;
var phi_7630_: type_25;
var phi_7650_: type_25;
var phi_7805_: vec3<f32>;
var phi_7931_: vec3<f32>;
var phi_7949_: type_25;
var phi_6946_: f32;
var phi_7950_: type_25;
var phi_8105_: f32;
var phi_8149_: type_25;
var phi_9384_: f32;
var phi_9411_: type_25;
var phi_9412_: type_25;
var phi_9413_: type_25;
var phi_9414_: type_25;
var phi_9415_: type_25;
var phi_4643_: f32;
var phi_4655_: type_25;
var phi_4696_: type_25;
var phi_5931_: f32;
var phi_5958_: type_25;
var phi_5959_: type_25;
var phi_9416_: type_25;
var phi_9417_: type_25;
var phi_9418_: bool;
var phi_9422_: type_25;
var phi_9423_: type_25;
var phi_2659_: f32;
var phi_2972_: i32;
var phi_3583_: i32;
var phi_3733_: type_26;
var phi_3727_: bool;
var phi_3728_: bool;
var phi_3734_: type_26;
var phi_3735_: bool;
var phi_3742_: type_17;
var phi_3743_: type_26;
var phi_3744_: type_17;
var phi_3746_: type_26;
var phi_3747_: type_17;
var phi_3748_: bool;
var phi_3752_: type_26;
var phi_3753_: type_17;
var phi_3754_: bool;
var phi_3758_: type_26;
var phi_3759_: type_17;
var phi_9425_: type_25;
var phi_9426_: bool;
var phi_2429_: type_25;
var phi_2432_: i32;
var phi_2434_: bool;
var local_10: type_25;
var local_11: type_25;
var local_12: type_25;
var local_13: type_25;
var local_14: type_25;
var local_15: type_25;
var local_16: type_25;
var local_17: type_25;
var local_18: type_25;
var local_19: type_25;
var local_20: type_25;
var local_21: type_25;
var local_22: type_25;
var local_23: type_25;
var local_24: type_25;
var local_25: type_25;
var local_26: type_25;
var local_27: type_25;
var local_28: type_25;
var local_29: type_25;
var local_30: type_25;
var local_31: type_25;
var local_32: type_25;
var local_33: type_25;
var local_34: type_25;
var local_35: type_25;
var local_36: type_25;
var local_37: type_25;
var local_38: type_25;
var local_39: type_25;
var local_40: type_25;
var local_41: type_25;
var local_42: type_25;
var local_43: type_25;
var local_44: type_25;
var local_45: type_25;
var local_46: type_25;
var local_47: type_25;
var local_48: type_25;
var local_49: type_25;
var local_50: type_25;
var local_51: f32;
let _e121 = global;
let _e123 = arrayLength((&global_1.member));
let _e125 = arrayLength((&global_2.member));
let _e127 = arrayLength((&global_3.member));
let _e134 = global_5.member.member;
if (_e121.x < _e134.member) {
if (_e121.y < _e134.member_1) {
let _e141 = (_e134.member * _e134.member_1);
let _e143 = ((_e121.y * _e134.member) + _e121.x);
let _e144 = bitcast<i32>(_e143);
let _e146 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e148 = select(_e146, _e144, (_e144 < _e146));
let _e154 = global_4.member[bitcast<u32>(select(0i, _e148, (_e148 > 0i)))];
let _e155 = (_e141 + _e143);
let _e156 = bitcast<i32>(_e155);
let _e158 = select(_e146, _e156, (_e156 < _e146));
let _e164 = global_4.member[bitcast<u32>(select(0i, _e158, (_e158 > 0i)))];
let _e166 = ((2u * _e141) + _e143);
let _e167 = bitcast<i32>(_e166);
let _e169 = select(_e146, _e167, (_e167 < _e146));
let _e175 = global_4.member[bitcast<u32>(select(0i, _e169, (_e169 > 0i)))];
let _e177 = ((3u * _e141) + _e143);
let _e178 = bitcast<i32>(_e177);
let _e180 = select(_e146, _e178, (_e178 < _e146));
let _e186 = global_4.member[bitcast<u32>(select(0i, _e180, (_e180 > 0i)))];
let _e188 = ((4u * _e141) + _e143);
let _e189 = bitcast<i32>(_e188);
let _e191 = select(_e146, _e189, (_e189 < _e146));
let _e197 = global_4.member[bitcast<u32>(select(0i, _e191, (_e191 > 0i)))];
let _e199 = ((5u * _e141) + _e143);
let _e200 = bitcast<i32>(_e199);
let _e202 = select(_e146, _e200, (_e200 < _e146));
let _e208 = global_4.member[bitcast<u32>(select(0i, _e202, (_e202 > 0i)))];
let _e210 = ((6u * _e141) + _e143);
let _e211 = bitcast<i32>(_e210);
let _e213 = select(_e146, _e211, (_e211 < _e146));
let _e219 = global_4.member[bitcast<u32>(select(0i, _e213, (_e213 > 0i)))];
let _e221 = ((7u * _e141) + _e143);
let _e222 = bitcast<i32>(_e221);
let _e224 = select(_e146, _e222, (_e222 < _e146));
let _e230 = global_4.member[bitcast<u32>(select(0i, _e224, (_e224 > 0i)))];
let _e232 = ((8u * _e141) + _e143);
let _e233 = bitcast<i32>(_e232);
let _e235 = select(_e146, _e233, (_e233 < _e146));
let _e241 = global_4.member[bitcast<u32>(select(0i, _e235, (_e235 > 0i)))];
let _e243 = ((9u * _e141) + _e143);
let _e244 = bitcast<i32>(_e243);
let _e246 = select(_e146, _e244, (_e244 < _e146));
let _e252 = global_4.member[bitcast<u32>(select(0i, _e246, (_e246 > 0i)))];
let _e254 = ((10u * _e141) + _e143);
let _e255 = bitcast<i32>(_e254);
let _e257 = select(_e146, _e255, (_e255 < _e146));
let _e263 = global_4.member[bitcast<u32>(select(0i, _e257, (_e257 > 0i)))];
let _e265 = ((11u * _e141) + _e143);
let _e266 = bitcast<i32>(_e265);
let _e268 = select(_e146, _e266, (_e266 < _e146));
let _e274 = global_4.member[bitcast<u32>(select(0i, _e268, (_e268 > 0i)))];
let _e276 = ((12u * _e141) + _e143);
let _e277 = bitcast<i32>(_e276);
let _e279 = select(_e146, _e277, (_e277 < _e146));
let _e285 = global_4.member[bitcast<u32>(select(0i, _e279, (_e279 > 0i)))];
let _e287 = ((13u * _e141) + _e143);
let _e288 = bitcast<i32>(_e287);
let _e290 = select(_e146, _e288, (_e288 < _e146));
let _e296 = global_4.member[bitcast<u32>(select(0i, _e290, (_e290 > 0i)))];
let _e298 = ((14u * _e141) + _e143);
let _e299 = bitcast<i32>(_e298);
let _e301 = select(_e146, _e299, (_e299 < _e146));
let _e307 = global_4.member[bitcast<u32>(select(0i, _e301, (_e301 > 0i)))];
let _e309 = ((15u * _e141) + _e143);
let _e310 = bitcast<i32>(_e309);
let _e312 = select(_e146, _e310, (_e310 < _e146));
let _e318 = global_4.member[bitcast<u32>(select(0i, _e312, (_e312 > 0i)))];
let _e320 = ((16u * _e141) + _e143);
let _e321 = bitcast<i32>(_e320);
let _e323 = select(_e146, _e321, (_e321 < _e146));
let _e329 = global_4.member[bitcast<u32>(select(0i, _e323, (_e323 > 0i)))];
let _e331 = ((17u * _e141) + _e143);
let _e332 = bitcast<i32>(_e331);
let _e334 = select(_e146, _e332, (_e332 < _e146));
let _e340 = global_4.member[bitcast<u32>(select(0i, _e334, (_e334 > 0i)))];
let _e342 = ((18u * _e141) + _e143);
let _e343 = bitcast<i32>(_e342);
let _e345 = select(_e146, _e343, (_e343 < _e146));
let _e351 = global_4.member[bitcast<u32>(select(0i, _e345, (_e345 > 0i)))];
let _e353 = ((19u * _e141) + _e143);
let _e354 = bitcast<i32>(_e353);
let _e356 = select(_e146, _e354, (_e354 < _e146));
let _e362 = global_4.member[bitcast<u32>(select(0i, _e356, (_e356 > 0i)))];
let _e364 = ((20u * _e141) + _e143);
let _e365 = bitcast<i32>(_e364);
let _e367 = select(_e146, _e365, (_e365 < _e146));
let _e373 = global_4.member[bitcast<u32>(select(0i, _e367, (_e367 > 0i)))];
let _e375 = ((21u * _e141) + _e143);
let _e376 = bitcast<i32>(_e375);
let _e378 = select(_e146, _e376, (_e376 < _e146));
let _e384 = global_4.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e386 = ((22u * _e141) + _e143);
let _e387 = bitcast<i32>(_e386);
let _e389 = select(_e146, _e387, (_e387 < _e146));
let _e395 = global_4.member[bitcast<u32>(select(0i, _e389, (_e389 > 0i)))];
let _e397 = ((23u * _e141) + _e143);
let _e398 = bitcast<i32>(_e397);
let _e400 = select(_e146, _e398, (_e398 < _e146));
let _e406 = global_4.member[bitcast<u32>(select(0i, _e400, (_e400 > 0i)))];
let _e408 = ((24u * _e141) + _e143);
let _e409 = bitcast<i32>(_e408);
let _e411 = select(_e146, _e409, (_e409 < _e146));
let _e417 = global_4.member[bitcast<u32>(select(0i, _e411, (_e411 > 0i)))];
let _e419 = ((25u * _e141) + _e143);
let _e420 = bitcast<i32>(_e419);
let _e422 = select(_e146, _e420, (_e420 < _e146));
let _e428 = global_4.member[bitcast<u32>(select(0i, _e422, (_e422 > 0i)))];
let _e430 = ((26u * _e141) + _e143);
let _e431 = bitcast<i32>(_e430);
let _e433 = select(_e146, _e431, (_e431 < _e146));
let _e439 = global_4.member[bitcast<u32>(select(0i, _e433, (_e433 > 0i)))];
let _e441 = ((27u * _e141) + _e143);
let _e442 = bitcast<i32>(_e441);
let _e444 = select(_e146, _e442, (_e442 < _e146));
let _e450 = global_4.member[bitcast<u32>(select(0i, _e444, (_e444 > 0i)))];
let _e452 = ((28u * _e141) + _e143);
let _e453 = bitcast<i32>(_e452);
let _e455 = select(_e146, _e453, (_e453 < _e146));
let _e461 = global_4.member[bitcast<u32>(select(0i, _e455, (_e455 > 0i)))];
let _e463 = ((29u * _e141) + _e143);
let _e464 = bitcast<i32>(_e463);
let _e466 = select(_e146, _e464, (_e464 < _e146));
let _e472 = global_4.member[bitcast<u32>(select(0i, _e466, (_e466 > 0i)))];
let _e474 = ((30u * _e141) + _e143);
let _e475 = bitcast<i32>(_e474);
let _e477 = select(_e146, _e475, (_e475 < _e146));
let _e483 = global_4.member[bitcast<u32>(select(0i, _e477, (_e477 > 0i)))];
let _e485 = ((31u * _e141) + _e143);
let _e486 = bitcast<i32>(_e485);
let _e488 = select(_e146, _e486, (_e486 < _e146));
let _e494 = global_4.member[bitcast<u32>(select(0i, _e488, (_e488 > 0i)))];
let _e496 = ((32u * _e141) + _e143);
let _e497 = bitcast<i32>(_e496);
let _e499 = select(_e146, _e497, (_e497 < _e146));
let _e505 = global_4.member[bitcast<u32>(select(0i, _e499, (_e499 > 0i)))];
let _e507 = ((33u * _e141) + _e143);
let _e508 = bitcast<i32>(_e507);
let _e510 = select(_e146, _e508, (_e508 < _e146));
let _e516 = global_4.member[bitcast<u32>(select(0i, _e510, (_e510 > 0i)))];
let _e518 = ((34u * _e141) + _e143);
let _e519 = bitcast<i32>(_e518);
let _e521 = select(_e146, _e519, (_e519 < _e146));
let _e527 = global_4.member[bitcast<u32>(select(0i, _e521, (_e521 > 0i)))];
let _e529 = ((35u * _e141) + _e143);
let _e530 = bitcast<i32>(_e529);
let _e532 = select(_e146, _e530, (_e530 < _e146));
let _e538 = global_4.member[bitcast<u32>(select(0i, _e532, (_e532 > 0i)))];
let _e540 = ((36u * _e141) + _e143);
let _e541 = bitcast<i32>(_e540);
let _e543 = select(_e146, _e541, (_e541 < _e146));
let _e549 = global_4.member[bitcast<u32>(select(0i, _e543, (_e543 > 0i)))];
let _e551 = ((37u * _e141) + _e143);
let _e552 = bitcast<i32>(_e551);
let _e554 = select(_e146, _e552, (_e552 < _e146));
let _e560 = global_4.member[bitcast<u32>(select(0i, _e554, (_e554 > 0i)))];
let _e562 = ((38u * _e141) + _e143);
let _e563 = bitcast<i32>(_e562);
let _e565 = select(_e146, _e563, (_e563 < _e146));
let _e571 = global_4.member[bitcast<u32>(select(0i, _e565, (_e565 > 0i)))];
let _e573 = ((39u * _e141) + _e143);
let _e574 = bitcast<i32>(_e573);
let _e576 = select(_e146, _e574, (_e574 < _e146));
let _e582 = global_4.member[bitcast<u32>(select(0i, _e576, (_e576 > 0i)))];
let _e584 = ((40u * _e141) + _e143);
let _e585 = bitcast<i32>(_e584);
let _e587 = select(_e146, _e585, (_e585 < _e146));
let _e593 = global_4.member[bitcast<u32>(select(0i, _e587, (_e587 > 0i)))];
let _e595 = ((41u * _e141) + _e143);
let _e596 = bitcast<i32>(_e595);
let _e598 = select(_e146, _e596, (_e596 < _e146));
let _e604 = global_4.member[bitcast<u32>(select(0i, _e598, (_e598 > 0i)))];
let _e611 = select(0i, select(select(i32(_e549), i32(-2147483648), (_e549 < -2147483600f)), 2147483647i, (_e549 > 2147483500f)), (_e549 == _e549));
let _e616 = global_5.member.member_12.member_4;
let _e622 = select(3u, 0u, ((_e472 == 3f) || ((_e472 == 2f) && (_e611 > bitcast<i32>(_e616)))));
if (_e622 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e631 = atomicLoad((&global_6.member[0u]));
if (_e631 == 0u) {
atomicStore((&global_6.member[0u]), ((_e134.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e134.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e622 > 1u) {
let _e693 = select(0i, select(select(i32(_e494), i32(-2147483648), (_e494 < -2147483600f)), 2147483647i, (_e494 > 2147483500f)), (_e494 == _e494));
let _e700 = select(0i, select(select(i32(_e505), i32(-2147483648), (_e505 < -2147483600f)), 2147483647i, (_e505 > 2147483500f)), (_e505 == _e505));
let _e707 = select(0i, select(select(i32(_e516), i32(-2147483648), (_e516 < -2147483600f)), 2147483647i, (_e516 > 2147483500f)), (_e516 == _e516));
let _e714 = select(0i, select(select(i32(_e527), i32(-2147483648), (_e527 < -2147483600f)), 2147483647i, (_e527 > 2147483500f)), (_e527 == _e527));
let _e721 = select(0i, select(select(i32(_e538), i32(-2147483648), (_e538 < -2147483600f)), 2147483647i, (_e538 > 2147483500f)), (_e538 == _e538));
if (_e472 == 0f) {
let _e729 = global_5.member.member_1.member;
let _e731 = f32(bitcast<i32>(_e729));
let _e735 = global_5.member.member_1.member_1;
let _e737 = f32(bitcast<i32>(_e735));
let _e747 = global_5.member.member_2.member;
let _e748 = (((((f32(bitcast<i32>(_e121.x)) + 0.5f) / _e731) * 2f) - 1f) * _e747);
let _e756 = global_5.member.member_2.member_1;
let _e757 = ((1f - (((f32(bitcast<i32>(_e121.y)) + 0.5f) / _e737) * 2f)) * _e756);
let _e760 = global_5.member.member_3;
let _e769 = global_5.member.member_4;
let _e776 = ((_e760.member * _e748) + (_e769.member * _e757));
let _e777 = ((_e760.member_1 * _e748) + (_e769.member_1 * _e757));
let _e778 = ((_e760.member_2 * _e748) + (_e769.member_2 * _e757));
let _e782 = global_5.member.member_2.member_3;
let _e783 = (_e782 != 0u);
let _e786 = global_5.member.member_5;
let _e793 = select((_e786.member + _e776), _e786.member, _e783);
let _e794 = select((_e786.member_1 + _e777), _e786.member_1, _e783);
let _e795 = select((_e786.member_2 + _e778), _e786.member_2, _e783);
let _e798 = global_5.member.member_6;
let _e805 = select(_e798.member, (_e798.member + _e776), _e783);
let _e806 = select(_e798.member_1, (_e798.member_1 + _e777), _e783);
let _e807 = select(_e798.member_2, (_e798.member_2 + _e778), _e783);
let _e813 = (((_e793 * _e793) + (_e794 * _e794)) + (_e795 * _e795));
let _e817 = (1f / sqrt(select(0f, _e813, (_e813 > 0f))));
let _e818 = (_e793 * _e817);
let _e819 = (_e794 * _e817);
let _e820 = (_e795 * _e817);
let _e823 = ((2f * _e747) / _e731);
let _e824 = (_e760.member * _e823);
let _e825 = (_e760.member_1 * _e823);
let _e826 = (_e760.member_2 * _e823);
let _e828 = ((-2f * _e756) / _e737);
let _e829 = (_e769.member * _e828);
let _e830 = (_e769.member_1 * _e828);
let _e831 = (_e769.member_2 * _e828);
let _e844 = (((_e824 * _e818) + (_e825 * _e819)) + (_e826 * _e820));
let _e854 = select(((_e824 - (_e818 * _e844)) * _e817), 0f, _e783);
let _e855 = select(((_e825 - (_e819 * _e844)) * _e817), 0f, _e783);
let _e856 = select(((_e826 - (_e820 * _e844)) * _e817), 0f, _e783);
let _e862 = (((_e829 * _e818) + (_e830 * _e819)) + (_e831 * _e820));
let _e872 = select(((_e829 - (_e818 * _e862)) * _e817), 0f, _e783);
let _e873 = select(((_e830 - (_e819 * _e862)) * _e817), 0f, _e783);
let _e874 = select(((_e831 - (_e820 * _e862)) * _e817), 0f, _e783);
let _e883 = (1f / select(_e818, select(1e-12f, -1e-12f, (_e818 < 0f)), (bitcast<f32>((bitcast<u32>(_e818) & 2147483647u)) < 1e-12f)));
let _e891 = (1f / select(_e819, select(1e-12f, -1e-12f, (_e819 < 0f)), (bitcast<f32>((bitcast<u32>(_e819) & 2147483647u)) < 1e-12f)));
let _e899 = (1f / select(_e820, select(1e-12f, -1e-12f, (_e820 < 0f)), (bitcast<f32>((bitcast<u32>(_e820) & 2147483647u)) < 1e-12f)));
let _e902 = global_5.member.member_8;
let _e908 = global_5.member.member_9;
let _e913 = ((_e902.member - _e805) * _e883);
let _e915 = ((_e908.member - _e805) * _e883);
let _e917 = ((_e902.member_1 - _e806) * _e891);
let _e919 = ((_e908.member_1 - _e806) * _e891);
let _e921 = ((_e902.member_2 - _e807) * _e899);
let _e923 = ((_e908.member_2 - _e807) * _e899);
let _e925 = select(_e915, _e913, (_e913 < _e915));
let _e927 = select(_e919, _e917, (_e917 < _e919));
let _e929 = select(_e927, _e925, (_e925 > _e927));
let _e931 = select(_e923, _e921, (_e921 < _e923));
let _e933 = select(_e931, _e929, (_e929 > _e931));
let _e935 = select(_e915, _e913, (_e913 > _e915));
let _e937 = select(_e919, _e917, (_e917 > _e919));
let _e939 = select(_e937, _e935, (_e935 < _e937));
let _e941 = select(_e923, _e921, (_e921 > _e923));
let _e945 = select(0f, _e933, (_e933 > 0f));
let _e950 = global_5.member.member_14.member.member;
let _e961 = ((((_e950.member.member * _e805) + (_e950.member.member_1 * _e806)) + (_e950.member.member_2 * _e807)) + _e950.member_1);
let _e967 = -((((_e950.member.member * _e818) + (_e950.member.member_1 * _e819)) + (_e950.member.member_2 * _e820)));
let _e969 = (_e967 > 1e-9f);
let _e971 = select(1e-9f, _e967, _e969);
let _e973 = ((_e961 / _e971) - 0.015625f);
let _e976 = select(1e30f, select(0f, _e973, (_e973 > 0f)), ((_e961 > 0f) && _e969));
let _e981 = global_5.member.member_14.member_1.member;
let _e992 = ((((_e981.member.member * _e805) + (_e981.member.member_1 * _e806)) + (_e981.member.member_2 * _e807)) + _e981.member_1);
let _e998 = -((((_e981.member.member * _e818) + (_e981.member.member_1 * _e819)) + (_e981.member.member_2 * _e820)));
let _e1000 = (_e998 > 1e-9f);
let _e1002 = select(1e-9f, _e998, _e1000);
let _e1004 = ((_e992 / _e1002) - 0.015625f);
let _e1007 = select(1e30f, select(0f, _e1004, (_e1004 > 0f)), ((_e992 > 0f) && _e1000));
let _e1013 = ((select(_e941, _e939, (_e939 < _e941)) <= _e945) || (true && (select(_e976, _e1007, (_e1007 < _e976)) <= _e945)));
let _e1014 = select(_e945, 0f, _e1013);
let _e1015 = (_e818 * _e1014);
let _e1016 = (_e819 * _e1014);
let _e1017 = (_e820 * _e1014);
let _e1018 = (_e805 + _e1015);
let _e1019 = (_e806 + _e1016);
let _e1020 = (_e807 + _e1017);
let _e1038 = ((((_e950.member.member * _e1018) + (_e950.member.member_1 * _e1019)) + (_e950.member.member_2 * _e1020)) + _e950.member_1);
let _e1042 = ((_e1038 / _e971) - 0.015625f);
let _e1045 = select(1e30f, select(0f, _e1042, (_e1042 > 0f)), ((_e1038 > 0f) && _e969));
let _e1051 = ((((_e981.member.member * _e1018) + (_e981.member.member_1 * _e1019)) + (_e981.member.member_2 * _e1020)) + _e981.member_1);
let _e1055 = ((_e1051 / _e1002) - 0.015625f);
let _e1058 = select(1e30f, select(0f, _e1055, (_e1055 > 0f)), ((_e1051 > 0f) && _e1000));
let _e1062 = (_e1058 < _e1045);
let _e1066 = type_25((vec3<f32>(_e805, _e806, _e807) + vec3<f32>(_e1015, _e1016, _e1017)), vec3<f32>(_e818, _e819, _e820), (vec3<f32>(select(0f, _e824, _e783), select(0f, _e825, _e783), select(0f, _e826, _e783)) + vec3<f32>((_e854 * _e1014), (_e855 * _e1014), (_e856 * _e1014))), (vec3<f32>(select(0f, _e829, _e783), select(0f, _e830, _e783), select(0f, _e831, _e783)) + vec3<f32>((_e872 * _e1014), (_e873 * _e1014), (_e874 * _e1014))), vec3<f32>(_e854, _e855, _e856), vec3<f32>(_e872, _e873, _e874), vec3<f32>(1f, 1f, 1f), 0i, 0i, select(select(-2i, -3i, _e1062), -1i, ((_e1045 >= 1e30f) && (_e1058 >= 1e30f))), select(_e1045, _e1058, _e1062), 0i, 0i, 0f, _e461, 1f, 0i, _e693, _e700, _e707, _e714, _e721, _e611, _e560, _e571, _e582, _e593, _e604);
let _e1070 = global_5.member.member_13.member_4;
let _e1077 = global_5.member.member_13.member_5;
let _e1082 = ((_e1070.member - _e805) * _e883);
let _e1084 = ((_e1077.member - _e805) * _e883);
let _e1086 = ((_e1070.member_1 - _e806) * _e891);
let _e1088 = ((_e1077.member_1 - _e806) * _e891);
let _e1090 = ((_e1070.member_2 - _e807) * _e899);
let _e1092 = ((_e1077.member_2 - _e807) * _e899);
let _e1094 = select(_e1084, _e1082, (_e1082 < _e1084));
let _e1096 = select(_e1088, _e1086, (_e1086 < _e1088));
let _e1098 = select(_e1096, _e1094, (_e1094 > _e1096));
let _e1100 = select(_e1092, _e1090, (_e1090 < _e1092));
let _e1102 = select(_e1100, _e1098, (_e1098 > _e1100));
let _e1104 = select(_e1084, _e1082, (_e1082 > _e1084));
let _e1106 = select(_e1088, _e1086, (_e1086 > _e1088));
let _e1108 = select(_e1106, _e1104, (_e1104 < _e1106));
let _e1110 = select(_e1092, _e1090, (_e1090 > _e1092));
let _e1112 = select(_e1110, _e1108, (_e1108 < _e1110));
let _e1114 = select(0f, _e1102, (_e1102 > 0f));
let _e1116 = select(_e1014, _e1112, (_e1112 < _e1014));
let _e1117 = (_e1116 > _e1114);
let _e1120 = (select(0f, _e1116, _e1117) - select(0f, _e1114, _e1117));
let _e1124 = global_5.member.member_13.member;
let _e1129 = -((_e1124.member * _e1120));
let _e1131 = select(-87f, _e1129, (_e1129 > -87f));
let _e1133 = select(88f, _e1131, (_e1131 < 88f));
let _e1135 = ((_e1133 * 1.442695f) + 0.5f);
let _e1137 = select(-127f, _e1135, (_e1135 > -127f));
let _e1139 = select(128f, _e1137, (_e1137 < 128f));
let _e1146 = select(0i, select(select(i32(_e1139), i32(-2147483648), (_e1139 < -2147483600f)), 2147483647i, (_e1139 > 2147483500f)), (_e1139 == _e1139));
let _e1150 = (_e1146 - select(0i, 1i, (_e1139 < f32(_e1146))));
let _e1151 = f32(_e1150);
let _e1155 = ((_e1133 - (_e1151 * 0.6933594f)) - (_e1151 * -2.1219444e-4f));
let _e1177 = -((_e1124.member_1 * _e1120));
let _e1179 = select(-87f, _e1177, (_e1177 > -87f));
let _e1181 = select(88f, _e1179, (_e1179 < 88f));
let _e1183 = ((_e1181 * 1.442695f) + 0.5f);
let _e1185 = select(-127f, _e1183, (_e1183 > -127f));
let _e1187 = select(128f, _e1185, (_e1185 < 128f));
let _e1194 = select(0i, select(select(i32(_e1187), i32(-2147483648), (_e1187 < -2147483600f)), 2147483647i, (_e1187 > 2147483500f)), (_e1187 == _e1187));
let _e1198 = (_e1194 - select(0i, 1i, (_e1187 < f32(_e1194))));
let _e1199 = f32(_e1198);
let _e1203 = ((_e1181 - (_e1199 * 0.6933594f)) - (_e1199 * -2.1219444e-4f));
let _e1225 = -((_e1124.member_2 * _e1120));
let _e1227 = select(-87f, _e1225, (_e1225 > -87f));
let _e1229 = select(88f, _e1227, (_e1227 < 88f));
let _e1231 = ((_e1229 * 1.442695f) + 0.5f);
let _e1233 = select(-127f, _e1231, (_e1231 > -127f));
let _e1235 = select(128f, _e1233, (_e1233 < 128f));
let _e1242 = select(0i, select(select(i32(_e1235), i32(-2147483648), (_e1235 < -2147483600f)), 2147483647i, (_e1235 > 2147483500f)), (_e1235 == _e1235));
let _e1246 = (_e1242 - select(0i, 1i, (_e1235 < f32(_e1242))));
let _e1247 = f32(_e1246);
let _e1251 = ((_e1229 - (_e1247 * 0.6933594f)) - (_e1247 * -2.1219444e-4f));
let _e1274 = (1f / 3f);
let _e1276 = (1f * ((1f + (_e1155 * (1f + (_e1155 * (0.5f + (_e1155 * (0.16666667f + (_e1155 * (0.041666668f + (_e1155 * (0.008333334f + (_e1155 * (0.001388889f + (_e1155 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1150 + 127i)) << bitcast<u32>(23i)))));
let _e1277 = (1f * ((1f + (_e1203 * (1f + (_e1203 * (0.5f + (_e1203 * (0.16666667f + (_e1203 * (0.041666668f + (_e1203 * (0.008333334f + (_e1203 * (0.001388889f + (_e1203 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1198 + 127i)) << bitcast<u32>(23i)))));
let _e1278 = (1f * ((1f + (_e1251 * (1f + (_e1251 * (0.5f + (_e1251 * (0.16666667f + (_e1251 * (0.041666668f + (_e1251 * (0.008333334f + (_e1251 * (0.001388889f + (_e1251 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1246 + 127i)) << bitcast<u32>(23i)))));
let _e1307 = type_25(_e1066.member, _e1066.member_1, _e1066.member_2, _e1066.member_3, _e1066.member_4, _e1066.member_5, vec3<f32>(_e1276, _e1277, _e1278), _e1066.member_7, _e1066.member_8, _e1066.member_9, _e1066.member_10, _e1066.member_11, _e1066.member_12, _e1066.member_13, _e1066.member_14, _e1066.member_15, _e1066.member_16, _e1066.member_17, _e1066.member_18, _e1066.member_19, _e1066.member_20, _e1066.member_21, _e1066.member_22, _e1066.member_23, _e1066.member_24, _e1066.member_25, _e1066.member_26, _e1066.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e714) {
phi_2378_ = ((((1f + 1f) + 1f) * _e1274) - (((_e1276 + _e1277) + _e1278) * _e1274));
} else {
phi_2378_ = 0f;
}
let _e1316 = phi_2378_;
let _e1345 = type_25(_e1307.member, _e1307.member_1, _e1307.member_2, _e1307.member_3, _e1307.member_4, _e1307.member_5, _e1307.member_6, _e1307.member_7, _e1307.member_8, _e1307.member_9, _e1307.member_10, _e1307.member_11, _e1307.member_12, _e1307.member_13, _e1307.member_14, _e1307.member_15, _e1307.member_16, _e1307.member_17, _e1307.member_18, _e1307.member_19, _e1307.member_20, _e1307.member_21, _e1307.member_22, _e1307.member_23, _e1307.member_24, _e1307.member_25, (_e593 + _e1316), _e1307.member_27);
if _e1013 {
phi_2405_ = type_25(_e1345.member, _e1345.member_1, _e1345.member_2, _e1345.member_3, _e1345.member_4, _e1345.member_5, _e1345.member_6, _e1345.member_7, (bitcast<i32>(_e123) / 8i), _e1345.member_9, _e1345.member_10, _e1345.member_11, _e1345.member_12, _e1345.member_13, _e1345.member_14, _e1345.member_15, _e1345.member_16, _e1345.member_17, _e1345.member_18, _e1345.member_19, _e1345.member_20, _e1345.member_21, _e1345.member_22, _e1345.member_23, _e1345.member_24, _e1345.member_25, _e1345.member_26, _e1345.member_27);
} else {
phi_2405_ = _e1345;
}
let _e1377 = phi_2405_;
phi_2406_ = _e1377;
} else {
phi_2406_ = type_25(vec3<f32>(_e154, _e164, _e175), vec3<f32>(_e186, _e197, _e208), vec3<f32>(_e219, _e230, _e241), vec3<f32>(_e252, _e263, _e274), vec3<f32>(_e285, _e296, _e307), vec3<f32>(_e318, _e329, _e340), vec3<f32>(_e351, _e362, _e373), select(0i, select(select(i32(_e384), i32(-2147483648), (_e384 < -2147483600f)), 2147483647i, (_e384 > 2147483500f)), (_e384 == _e384)), select(0i, select(select(i32(_e395), i32(-2147483648), (_e395 < -2147483600f)), 2147483647i, (_e395 > 2147483500f)), (_e395 == _e395)), select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < -2147483600f)), 2147483647i, (_e406 > 2147483500f)), (_e406 == _e406)), _e417, select(0i, select(select(i32(_e428), i32(-2147483648), (_e428 < -2147483600f)), 2147483647i, (_e428 > 2147483500f)), (_e428 == _e428)), select(0i, select(select(i32(_e439), i32(-2147483648), (_e439 < -2147483600f)), 2147483647i, (_e439 > 2147483500f)), (_e439 == _e439)), _e450, _e461, _e472, select(0i, select(select(i32(_e483), i32(-2147483648), (_e483 < -2147483600f)), 2147483647i, (_e483 > 2147483500f)), (_e483 == _e483)), _e693, _e700, _e707, _e714, _e721, _e611, _e560, _e571, _e582, _e593, _e604);
}
let _e1379 = phi_2406_;
let _e1380 = bitcast<i32>(_e123);
let _e1381 = (_e1380 / 8i);
let _e1383 = (_e1379.member_15 == 2f);
if _e1383 {
phi_2426_ = type_25(_e1379.member, _e1379.member_1, _e1379.member_2, _e1379.member_3, _e1379.member_4, _e1379.member_5, _e1379.member_6, _e1379.member_7, _e1379.member_8, _e1379.member_9, _e1379.member_10, _e1379.member_11, _e1379.member_12, _e1379.member_13, _e1379.member_14, 1f, _e1379.member_16, _e1379.member_17, _e1379.member_18, _e1379.member_19, _e1379.member_20, _e1379.member_21, _e1379.member_22, _e1379.member_23, _e1379.member_24, _e1379.member_25, _e1379.member_26, _e1379.member_27);
} else {
phi_2426_ = _e1379;
}
let _e1413 = phi_2426_;
phi_2428_ = _e1413;
phi_2431_ = 0i;
phi_2433_ = _e1383;
loop {
let _e1415 = phi_2428_;
let _e1417 = phi_2431_;
let _e1419 = phi_2433_;
local_10 = _e1415;
local_11 = _e1415;
local_12 = _e1415;
local_13 = _e1415;
local_14 = _e1415;
local_15 = _e1415;
local_16 = _e1415;
local_17 = _e1415;
local_18 = _e1415;
local_19 = _e1415;
local_20 = _e1415;
local_21 = _e1415;
local_22 = _e1415;
local_23 = _e1415;
local_24 = _e1415;
local_25 = _e1415;
local_26 = _e1415;
local_27 = _e1415;
local_28 = _e1415;
local_29 = _e1415;
local_30 = _e1415;
local_31 = _e1415;
local_32 = _e1415;
local_33 = _e1415;
local_34 = _e1415;
local_35 = _e1415;
local_36 = _e1415;
local_37 = _e1415;
local_38 = _e1415;
local_39 = _e1415;
local_40 = _e1415;
local_41 = _e1415;
local_42 = _e1415;
local_43 = _e1415;
local_44 = _e1415;
local_45 = _e1415;
local_46 = _e1415;
local_47 = _e1415;
local_48 = _e1415;
local_49 = _e1415;
local_50 = _e1415;
let _e1423 = ((_e1417 < 1024i) && (_e1415.member_15 == 1f));
local_51 = _e1415.member_15;
if _e1423 {
if (_e1415.member_8 < _e1381) {
let _e7290 = f32(_e1415.member_11);
let _e7292 = f32(_e1415.member_12);
let _e7294 = vec3<f32>(_e7290, _e7292, _e1415.member_13);
let _e7296 = (_e1415.member_9 >= 0i);
if _e7296 {
let _e7297 = (_e1415.member_9 * 19i);
let _e7299 = (bitcast<i32>(_e125) - 1i);
let _e7301 = select(_e7299, _e7297, (_e7297 < _e7299));
let _e7307 = global_2.member[bitcast<u32>(select(0i, _e7301, (_e7301 > 0i)))];
let _e7308 = (_e7297 + 1i);
let _e7310 = select(_e7299, _e7308, (_e7308 < _e7299));
let _e7316 = global_2.member[bitcast<u32>(select(0i, _e7310, (_e7310 > 0i)))];
let _e7317 = (_e7297 + 2i);
let _e7319 = select(_e7299, _e7317, (_e7317 < _e7299));
let _e7325 = global_2.member[bitcast<u32>(select(0i, _e7319, (_e7319 > 0i)))];
let _e7326 = (_e7297 + 3i);
let _e7328 = select(_e7299, _e7326, (_e7326 < _e7299));
let _e7334 = global_2.member[bitcast<u32>(select(0i, _e7328, (_e7328 > 0i)))];
let _e7335 = (_e7297 + 4i);
let _e7337 = select(_e7299, _e7335, (_e7335 < _e7299));
let _e7343 = global_2.member[bitcast<u32>(select(0i, _e7337, (_e7337 > 0i)))];
let _e7344 = (_e7297 + 5i);
let _e7346 = select(_e7299, _e7344, (_e7344 < _e7299));
let _e7352 = global_2.member[bitcast<u32>(select(0i, _e7346, (_e7346 > 0i)))];
let _e7353 = (_e7334 - _e7307);
let _e7354 = (_e7343 - _e7316);
let _e7355 = (_e7352 - _e7325);
let _e7356 = (_e7297 + 6i);
let _e7358 = select(_e7299, _e7356, (_e7356 < _e7299));
let _e7364 = global_2.member[bitcast<u32>(select(0i, _e7358, (_e7358 > 0i)))];
let _e7365 = (_e7297 + 7i);
let _e7367 = select(_e7299, _e7365, (_e7365 < _e7299));
let _e7373 = global_2.member[bitcast<u32>(select(0i, _e7367, (_e7367 > 0i)))];
let _e7374 = (_e7297 + 8i);
let _e7376 = select(_e7299, _e7374, (_e7374 < _e7299));
let _e7382 = global_2.member[bitcast<u32>(select(0i, _e7376, (_e7376 > 0i)))];
let _e7383 = (_e7364 - _e7307);
let _e7384 = (_e7373 - _e7316);
let _e7385 = (_e7382 - _e7325);
let _e7388 = ((_e7354 * _e7385) - (_e7355 * _e7384));
let _e7391 = ((_e7355 * _e7383) - (_e7353 * _e7385));
let _e7394 = ((_e7353 * _e7384) - (_e7354 * _e7383));
let _e7399 = (((_e7388 * _e7388) + (_e7391 * _e7391)) + (_e7394 * _e7394));
let _e7402 = sqrt(select(0f, _e7399, (_e7399 > 0f)));
let _e7405 = (1f / select(1e-20f, _e7402, (_e7402 > 1e-20f)));
phi_2659_ = (((_e1415.member_1.x * (_e7388 * _e7405)) + (_e1415.member_1.y * (_e7391 * _e7405))) + (_e1415.member_1.z * (_e7394 * _e7405)));
} else {
phi_2659_ = 1f;
}
let _e7418 = phi_2659_;
let _e7425 = select(0i, select(select(i32(_e7290), i32(-2147483648), (_e7290 < -2147483600f)), 2147483647i, (_e7290 > 2147483500f)), (_e7290 == _e7290));
let _e7432 = select(0i, select(select(i32(_e7292), i32(-2147483648), (_e7292 < -2147483600f)), 2147483647i, (_e7292 > 2147483500f)), (_e7292 == _e7292));
let _e7435 = bitcast<f32>((bitcast<u32>(_e7418) & 2147483647u));
let _e7437 = select(1e-3f, _e7435, (_e7435 > 1e-3f));
let _e7438 = type_26(_e7425, _e7432, _e1415.member_13, _e1415.member_14, _e7437);
let _e7443 = global_5.member.member_12.member;
let _e7446 = (_e1415.member_10 + select(0f, (_e7443 / _e7437), _e7296));
let _e7450 = (_e1415.member_8 * 8i);
let _e7453 = bitcast<f32>((bitcast<u32>(_e1415.member_1.x) & 2147483647u));
let _e7458 = (1f / select(_e1415.member_1.x, select(1e-12f, -1e-12f, (_e1415.member_1.x < 0f)), (_e7453 < 1e-12f)));
let _e7461 = bitcast<f32>((bitcast<u32>(_e1415.member_1.y) & 2147483647u));
let _e7466 = (1f / select(_e1415.member_1.y, select(1e-12f, -1e-12f, (_e1415.member_1.y < 0f)), (_e7461 < 1e-12f)));
let _e7469 = bitcast<f32>((bitcast<u32>(_e1415.member_1.z) & 2147483647u));
let _e7474 = (1f / select(_e1415.member_1.z, select(1e-12f, -1e-12f, (_e1415.member_1.z < 0f)), (_e7469 < 1e-12f)));
let _e7475 = (_e1380 - 1i);
let _e7477 = select(_e7475, _e7450, (_e7450 < _e7475));
let _e7483 = global_1.member[bitcast<u32>(select(0i, _e7477, (_e7477 > 0i)))];
let _e7484 = (_e7450 + 1i);
let _e7486 = select(_e7475, _e7484, (_e7484 < _e7475));
let _e7492 = global_1.member[bitcast<u32>(select(0i, _e7486, (_e7486 > 0i)))];
let _e7493 = (_e7450 + 2i);
let _e7495 = select(_e7475, _e7493, (_e7493 < _e7475));
let _e7501 = global_1.member[bitcast<u32>(select(0i, _e7495, (_e7495 > 0i)))];
let _e7502 = (_e7450 + 3i);
let _e7504 = select(_e7475, _e7502, (_e7502 < _e7475));
let _e7510 = global_1.member[bitcast<u32>(select(0i, _e7504, (_e7504 > 0i)))];
let _e7511 = (_e7450 + 4i);
let _e7513 = select(_e7475, _e7511, (_e7511 < _e7475));
let _e7519 = global_1.member[bitcast<u32>(select(0i, _e7513, (_e7513 > 0i)))];
let _e7520 = (_e7450 + 5i);
let _e7522 = select(_e7475, _e7520, (_e7520 < _e7475));
let _e7528 = global_1.member[bitcast<u32>(select(0i, _e7522, (_e7522 > 0i)))];
let _e7531 = ((_e7483 - _e1415.member.x) * _e7458);
let _e7533 = ((_e7510 - _e1415.member.x) * _e7458);
let _e7536 = ((_e7492 - _e1415.member.y) * _e7466);
let _e7538 = ((_e7519 - _e1415.member.y) * _e7466);
let _e7541 = ((_e7501 - _e1415.member.z) * _e7474);
let _e7543 = ((_e7528 - _e1415.member.z) * _e7474);
let _e7545 = select(_e7533, _e7531, (_e7531 < _e7533));
let _e7547 = select(_e7538, _e7536, (_e7536 < _e7538));
let _e7549 = select(_e7547, _e7545, (_e7545 > _e7547));
let _e7551 = select(_e7543, _e7541, (_e7541 < _e7543));
let _e7555 = select(_e7533, _e7531, (_e7531 > _e7533));
let _e7557 = select(_e7538, _e7536, (_e7536 > _e7538));
let _e7559 = select(_e7557, _e7555, (_e7555 < _e7557));
let _e7561 = select(_e7543, _e7541, (_e7541 > _e7543));
let _e7563 = select(_e7561, _e7559, (_e7559 < _e7561));
let _e7568 = ((select(_e7551, _e7549, (_e7549 > _e7551)) <= select(_e7446, _e7563, (_e7563 < _e7446))) && (_e7563 >= _e1415.member_13));
let _e7569 = (_e7450 + 6i);
let _e7571 = select(_e7475, _e7569, (_e7569 < _e7475));
let _e7577 = global_1.member[bitcast<u32>(select(0i, _e7571, (_e7571 > 0i)))];
if _e7568 {
phi_2972_ = (_e1415.member_8 + 1i);
} else {
let _e7585 = (_e7450 + 7i);
let _e7587 = select(_e7475, _e7585, (_e7585 < _e7475));
let _e7593 = global_1.member[bitcast<u32>(select(0i, _e7587, (_e7587 > 0i)))];
phi_2972_ = select(0i, select(select(i32(_e7593), i32(-2147483648), (_e7593 < -2147483600f)), 2147483647i, (_e7593 > 2147483500f)), (_e7593 == _e7593));
}
let _e7603 = phi_2972_;
let _e7604 = type_17(_e1415.member, _e1415.member_1, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), _e7294, _e1415.member_14, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, _e7603, _e1415.member_9, _e1415.member_10);
let _e7605 = select(-1i, select(0i, select(select(i32(_e7577), i32(-2147483648), (_e7577 < -2147483600f)), 2147483647i, (_e7577 > 2147483500f)), (_e7577 == _e7577)), _e7568);
if (_e7605 < 0i) {
phi_3752_ = type_26();
phi_3753_ = type_17();
phi_3754_ = true;
} else {
let _e7609 = ((_e7453 >= _e7461) && (_e7453 >= _e7469));
let _e7612 = (!(_e7609) && (_e7461 >= _e7469));
let _e7619 = (1f / select(select(_e1415.member_1.z, _e1415.member_1.y, _e7612), _e1415.member_1.x, _e7609));
let _e7620 = (select(select(_e1415.member_1.x, _e1415.member_1.z, _e7612), _e1415.member_1.y, _e7609) * _e7619);
let _e7621 = (select(select(_e1415.member_1.y, _e1415.member_1.x, _e7612), _e1415.member_1.z, _e7609) * _e7619);
let _e7622 = (_e7605 * 19i);
let _e7624 = (bitcast<i32>(_e125) - 1i);
let _e7626 = select(_e7624, _e7622, (_e7622 < _e7624));
let _e7632 = global_2.member[bitcast<u32>(select(0i, _e7626, (_e7626 > 0i)))];
let _e7633 = (_e7622 + 1i);
let _e7635 = select(_e7624, _e7633, (_e7633 < _e7624));
let _e7641 = global_2.member[bitcast<u32>(select(0i, _e7635, (_e7635 > 0i)))];
let _e7642 = (_e7622 + 2i);
let _e7644 = select(_e7624, _e7642, (_e7642 < _e7624));
let _e7650 = global_2.member[bitcast<u32>(select(0i, _e7644, (_e7644 > 0i)))];
let _e7651 = (_e7632 - _e1415.member.x);
let _e7652 = (_e7641 - _e1415.member.y);
let _e7653 = (_e7650 - _e1415.member.z);
let _e7659 = select(select(_e7653, _e7652, _e7612), _e7651, _e7609);
let _e7661 = (select(select(_e7651, _e7653, _e7612), _e7652, _e7609) - (_e7620 * _e7659));
let _e7663 = (select(select(_e7652, _e7651, _e7612), _e7653, _e7609) - (_e7621 * _e7659));
let _e7665 = (_e7622 + 3i);
let _e7667 = select(_e7624, _e7665, (_e7665 < _e7624));
let _e7673 = global_2.member[bitcast<u32>(select(0i, _e7667, (_e7667 > 0i)))];
let _e7674 = (_e7622 + 4i);
let _e7676 = select(_e7624, _e7674, (_e7674 < _e7624));
let _e7682 = global_2.member[bitcast<u32>(select(0i, _e7676, (_e7676 > 0i)))];
let _e7683 = (_e7622 + 5i);
let _e7685 = select(_e7624, _e7683, (_e7683 < _e7624));
let _e7691 = global_2.member[bitcast<u32>(select(0i, _e7685, (_e7685 > 0i)))];
let _e7692 = (_e7673 - _e1415.member.x);
let _e7693 = (_e7682 - _e1415.member.y);
let _e7694 = (_e7691 - _e1415.member.z);
let _e7700 = select(select(_e7694, _e7693, _e7612), _e7692, _e7609);
let _e7702 = (select(select(_e7692, _e7694, _e7612), _e7693, _e7609) - (_e7620 * _e7700));
let _e7704 = (select(select(_e7693, _e7692, _e7612), _e7694, _e7609) - (_e7621 * _e7700));
let _e7706 = (_e7622 + 6i);
let _e7708 = select(_e7624, _e7706, (_e7706 < _e7624));
let _e7714 = global_2.member[bitcast<u32>(select(0i, _e7708, (_e7708 > 0i)))];
let _e7715 = (_e7622 + 7i);
let _e7717 = select(_e7624, _e7715, (_e7715 < _e7624));
let _e7723 = global_2.member[bitcast<u32>(select(0i, _e7717, (_e7717 > 0i)))];
let _e7724 = (_e7622 + 8i);
let _e7726 = select(_e7624, _e7724, (_e7724 < _e7624));
let _e7732 = global_2.member[bitcast<u32>(select(0i, _e7726, (_e7726 > 0i)))];
let _e7733 = (_e7714 - _e1415.member.x);
let _e7734 = (_e7723 - _e1415.member.y);
let _e7735 = (_e7732 - _e1415.member.z);
let _e7741 = select(select(_e7735, _e7734, _e7612), _e7733, _e7609);
let _e7743 = (select(select(_e7733, _e7735, _e7612), _e7734, _e7609) - (_e7620 * _e7741));
let _e7745 = (select(select(_e7734, _e7733, _e7612), _e7735, _e7609) - (_e7621 * _e7741));
let _e7749 = ((_e7743 * _e7704) - (_e7745 * _e7702));
let _e7752 = ((_e7661 * _e7745) - (_e7663 * _e7743));
let _e7755 = ((_e7702 * _e7663) - (_e7704 * _e7661));
let _e7757 = ((_e7749 + _e7752) + _e7755);
let _e7771 = (!(((((_e7749 < 0f) || (_e7752 < 0f)) || (_e7755 < 0f)) && (((_e7749 > 0f) || (_e7752 > 0f)) || (_e7755 > 0f)))) && (_e7757 != 0f));
let _e7779 = select(1e30f, ((((_e7749 * (_e7659 * _e7619)) + (_e7752 * (_e7700 * _e7619))) + (_e7755 * (_e7741 * _e7619))) / select(1f, _e7757, _e7771)), _e7771);
if (_e7779 >= _e7446) {
phi_3746_ = type_26();
phi_3747_ = type_17();
phi_3748_ = true;
} else {
let _e7781 = (_e7673 - _e7632);
let _e7782 = (_e7682 - _e7641);
let _e7783 = (_e7691 - _e7650);
let _e7784 = (_e7714 - _e7632);
let _e7785 = (_e7723 - _e7641);
let _e7786 = (_e7732 - _e7650);
let _e7789 = ((_e7782 * _e7786) - (_e7783 * _e7785));
let _e7792 = ((_e7783 * _e7784) - (_e7781 * _e7786));
let _e7795 = ((_e7781 * _e7785) - (_e7782 * _e7784));
let _e7800 = (((_e7789 * _e7789) + (_e7792 * _e7792)) + (_e7795 * _e7795));
let _e7803 = sqrt(select(0f, _e7800, (_e7800 > 0f)));
let _e7806 = (1f / select(1e-20f, _e7803, (_e7803 > 1e-20f)));
let _e7814 = (((_e1415.member_1.x * (_e7789 * _e7806)) + (_e1415.member_1.y * (_e7792 * _e7806))) + (_e1415.member_1.z * (_e7795 * _e7806)));
let _e7817 = bitcast<f32>((bitcast<u32>(_e7814) & 2147483647u));
let _e7819 = select(1e-3f, _e7817, (_e7817 > 1e-3f));
let _e7820 = (_e7622 + 18i);
let _e7822 = select(_e7624, _e7820, (_e7820 < _e7624));
let _e7828 = global_2.member[bitcast<u32>(select(0i, _e7822, (_e7822 > 0i)))];
let _e7835 = select(0i, select(select(i32(_e7828), i32(-2147483648), (_e7828 < -2147483600f)), 2147483647i, (_e7828 > 2147483500f)), (_e7828 == _e7828));
let _e7836 = (_e7835 * 4i);
let _e7838 = (bitcast<i32>(_e127) - 1i);
let _e7840 = select(_e7838, _e7836, (_e7836 < _e7838));
let _e7846 = global_3.member[bitcast<u32>(select(0i, _e7840, (_e7840 > 0i)))];
let _e7848 = select(_e7846, 1f, (_e7835 == 16i));
let _e7849 = (_e7848 <= 0f);
if _e7849 {
phi_3583_ = 0i;
} else {
phi_3583_ = (1i << bitcast<u32>((_e7835 & 31i)));
}
let _e7854 = phi_3583_;
let _e7855 = (_e7814 < 0f);
let _e7856 = select(_e7854, 0i, _e7855);
let _e7857 = select(0i, _e7854, _e7855);
let _e7866 = (_e7779 * _e7819);
let _e7879 = (((_e7779 > _e1415.member_13) && (_e1415.member_13 > 0f)) || (((_e7866 > (_e7443 * 2f)) || ((((_e7848 == 0f) || ((_e7857 & ~(_e1415.member_7)) != 0i)) || ((_e7856 & _e1415.member_7) != 0i)) && (_e7866 >= -((_e7443 * 0.5f))))) && (_e1415.member_13 <= 0f)));
if _e7879 {
let _e7880 = (_e7779 < _e1415.member_10);
if (_e7296 && ((bitcast<f32>((bitcast<u32>((_e7779 - _e1415.member_10)) & 2147483647u)) * select(_e7437, _e7819, (_e7819 > _e7437))) <= _e7443)) {
let _e7899 = ((_e1415.member_9 * 19i) + 18i);
let _e7901 = select(_e7624, _e7899, (_e7899 < _e7624));
let _e7907 = global_2.member[bitcast<u32>(select(0i, _e7901, (_e7901 > 0i)))];
let _e7914 = select(0i, select(select(i32(_e7907), i32(-2147483648), (_e7907 < -2147483600f)), 2147483647i, (_e7907 > 2147483500f)), (_e7907 == _e7907));
let _e7915 = (_e7914 * 4i);
let _e7917 = select(_e7838, _e7915, (_e7915 < _e7838));
let _e7923 = global_3.member[bitcast<u32>(select(0i, _e7917, (_e7917 > 0i)))];
if (_e7849 != (select(_e7923, 1f, (_e7914 == 16i)) <= 0f)) {
phi_3728_ = _e7849;
} else {
if (!(_e7849) && (_e7835 != _e7914)) {
phi_3727_ = (_e7835 < _e7914);
} else {
phi_3727_ = _e7880;
}
let _e7933 = phi_3727_;
phi_3728_ = _e7933;
}
let _e7935 = phi_3728_;
phi_3734_ = type_26((_e7425 | _e7857), (_e7432 | _e7856), _e1415.member_13, select(_e7779, _e1415.member_14, (_e1415.member_14 > _e7779)), _e7437);
phi_3735_ = _e7935;
} else {
if _e7880 {
phi_3733_ = type_26(_e7857, _e7856, _e1415.member_13, _e7779, _e7437);
} else {
phi_3733_ = _e7438;
}
let _e7892 = phi_3733_;
phi_3734_ = _e7892;
phi_3735_ = _e7880;
}
let _e7937 = phi_3734_;
let _e7939 = phi_3735_;
if _e7939 {
phi_3742_ = type_17(_e1415.member, _e1415.member_1, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), _e7294, _e1415.member_14, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, _e7603, _e7605, _e7779);
} else {
phi_3742_ = _e7604;
}
let _e7942 = phi_3742_;
phi_3743_ = _e7937;
phi_3744_ = _e7942;
} else {
phi_3743_ = type_26();
phi_3744_ = type_17();
}
let _e7944 = phi_3743_;
let _e7946 = phi_3744_;
phi_3746_ = _e7944;
phi_3747_ = _e7946;
phi_3748_ = select(true, false, _e7879);
}
let _e7949 = phi_3746_;
let _e7951 = phi_3747_;
let _e7953 = phi_3748_;
phi_3752_ = _e7949;
phi_3753_ = _e7951;
phi_3754_ = _e7953;
}
let _e7955 = phi_3752_;
let _e7957 = phi_3753_;
let _e7959 = phi_3754_;
if _e7959 {
phi_3758_ = _e7438;
phi_3759_ = _e7604;
} else {
phi_3758_ = _e7955;
phi_3759_ = _e7957;
}
let _e7961 = phi_3758_;
let _e7963 = phi_3759_;
let _e7992 = type_25(_e1415.member, _e1415.member_1, _e1415.member_2, _e1415.member_3, _e1415.member_4, _e1415.member_5, _e1415.member_6, _e1415.member_7, _e7963.member_15, _e1415.member_9, _e1415.member_10, _e1415.member_11, _e1415.member_12, _e1415.member_13, _e1415.member_14, _e1415.member_15, _e1415.member_16, _e1415.member_17, _e1415.member_18, _e1415.member_19, _e1415.member_20, _e1415.member_21, _e1415.member_22, _e1415.member_23, _e1415.member_24, _e1415.member_25, _e1415.member_26, _e1415.member_27);
let _e8021 = type_25(_e7992.member, _e7992.member_1, _e7992.member_2, _e7992.member_3, _e7992.member_4, _e7992.member_5, _e7992.member_6, _e7992.member_7, _e7992.member_8, _e7963.member_16, _e7992.member_10, _e7992.member_11, _e7992.member_12, _e7992.member_13, _e7992.member_14, _e7992.member_15, _e7992.member_16, _e7992.member_17, _e7992.member_18, _e7992.member_19, _e7992.member_20, _e7992.member_21, _e7992.member_22, _e7992.member_23, _e7992.member_24, _e7992.member_25, _e7992.member_26, _e7992.member_27);
let _e8050 = type_25(_e8021.member, _e8021.member_1, _e8021.member_2, _e8021.member_3, _e8021.member_4, _e8021.member_5, _e8021.member_6, _e8021.member_7, _e8021.member_8, _e8021.member_9, _e7963.member_17, _e8021.member_11, _e8021.member_12, _e8021.member_13, _e8021.member_14, _e8021.member_15, _e8021.member_16, _e8021.member_17, _e8021.member_18, _e8021.member_19, _e8021.member_20, _e8021.member_21, _e8021.member_22, _e8021.member_23, _e8021.member_24, _e8021.member_25, _e8021.member_26, _e8021.member_27);
let _e8079 = type_25(_e8050.member, _e8050.member_1, _e8050.member_2, _e8050.member_3, _e8050.member_4, _e8050.member_5, _e8050.member_6, _e8050.member_7, _e8050.member_8, _e8050.member_9, _e8050.member_10, _e7961.member, _e8050.member_12, _e8050.member_13, _e8050.member_14, _e8050.member_15, _e8050.member_16, _e8050.member_17, _e8050.member_18, _e8050.member_19, _e8050.member_20, _e8050.member_21, _e8050.member_22, _e8050.member_23, _e8050.member_24, _e8050.member_25, _e8050.member_26, _e8050.member_27);
let _e8108 = type_25(_e8079.member, _e8079.member_1, _e8079.member_2, _e8079.member_3, _e8079.member_4, _e8079.member_5, _e8079.member_6, _e8079.member_7, _e8079.member_8, _e8079.member_9, _e8079.member_10, _e8079.member_11, _e7961.member_1, _e8079.member_13, _e8079.member_14, _e8079.member_15, _e8079.member_16, _e8079.member_17, _e8079.member_18, _e8079.member_19, _e8079.member_20, _e8079.member_21, _e8079.member_22, _e8079.member_23, _e8079.member_24, _e8079.member_25, _e8079.member_26, _e8079.member_27);
phi_9425_ = type_25(_e8108.member, _e8108.member_1, _e8108.member_2, _e8108.member_3, _e8108.member_4, _e8108.member_5, _e8108.member_6, _e8108.member_7, _e8108.member_8, _e8108.member_9, _e8108.member_10, _e8108.member_11, _e8108.member_12, _e8108.member_13, _e7961.member_3, _e8108.member_15, _e8108.member_16, _e8108.member_17, _e8108.member_18, _e8108.member_19, _e8108.member_20, _e8108.member_21, _e8108.member_22, _e8108.member_23, _e8108.member_24, _e8108.member_25, _e8108.member_26, _e8108.member_27);
phi_9426_ = _e1419;
} else {
phi_3774_ = 15i;
phi_3777_ = 16i;
loop {
let _e1429 = phi_3774_;
let _e1431 = phi_3777_;
local = _e1431;
local_1 = _e1431;
local_2 = _e1431;
local_4 = _e1431;
local_7 = _e1431;
let _e1432 = (_e1429 >= 0i);
if _e1432 {
phi_3775_ = (_e1429 - 1i);
phi_3778_ = select(_e1431, _e1429, (((_e1415.member_7 >> bitcast<u32>((_e1429 & 31i))) & 1i) == 1i));
} else {
phi_3775_ = i32();
phi_3778_ = i32();
}
let _e1441 = phi_3775_;
let _e1443 = phi_3778_;
continue;
continuing {
phi_3774_ = _e1441;
phi_3777_ = _e1443;
break if !(_e1432);
}
}
let _e1446 = local;
let _e1447 = (_e1446 == 16i);
let _e1459 = (bitcast<i32>(countOneBits(bitcast<u32>((_e1415.member_17 & ((1i << bitcast<u32>((_e1415.member_16 & 31i))) - 1i))))) == _e1415.member_20);
let _e1462 = ((_e1447 && _e1459) && !(_e1419));
if _e1462 {
let _e7251 = type_25(_e1415.member, _e1415.member_1, _e1415.member_2, _e1415.member_3, _e1415.member_4, _e1415.member_5, _e1415.member_6, _e1415.member_7, _e1415.member_8, _e1415.member_9, _e1415.member_10, _e1415.member_11, _e1415.member_12, _e1415.member_13, _e1415.member_14, 2f, _e1415.member_16, _e1415.member_17, _e1415.member_18, _e1415.member_19, _e1415.member_20, _e1415.member_21, _e1415.member_22, _e1415.member_23, _e1415.member_24, _e1415.member_25, _e1415.member_26, _e1415.member_27);
phi_9423_ = type_25(_e7251.member, _e7251.member_1, _e7251.member_2, _e7251.member_3, _e7251.member_4, _e7251.member_5, _e7251.member_6, _e7251.member_7, _e7251.member_8, _e7251.member_9, _e7251.member_10, _e7251.member_11, _e7251.member_12, _e7251.member_13, _e7251.member_14, _e7251.member_15, _e7251.member_16, _e7251.member_17, _e7251.member_18, _e7251.member_19, _e7251.member_20, _e7251.member_21, (_e1415.member_22 + 1i), _e7251.member_23, _e7251.member_24, _e7251.member_25, _e7251.member_26, _e7251.member_27);
} else {
let _e1464 = (_e1415.member_9 >= 0i);
let _e1467 = (_e1415.member_10 - _e1415.member_13);
let _e1469 = select(0f, _e1467, (_e1467 > 0f));
let _e1472 = ((select(0i, _e1415.member_9, _e1464) * 19i) + 18i);
let _e1474 = (bitcast<i32>(_e125) - 1i);
let _e1476 = select(_e1474, _e1472, (_e1472 < _e1474));
let _e1482 = global_2.member[bitcast<u32>(select(0i, _e1476, (_e1476 > 0i)))];
let _e1489 = select(0i, select(select(i32(_e1482), i32(-2147483648), (_e1482 < -2147483600f)), 2147483647i, (_e1482 > 2147483500f)), (_e1482 == _e1482));
let _e1490 = (_e1489 * 4i);
let _e1492 = (bitcast<i32>(_e127) - 1i);
let _e1494 = select(_e1492, _e1490, (_e1490 < _e1492));
let _e1500 = global_3.member[bitcast<u32>(select(0i, _e1494, (_e1494 > 0i)))];
let _e1502 = select(_e1500, 1f, (_e1489 == 16i));
let _e1504 = (_e1464 && (_e1502 <= 0f));
let _e1513 = ((_e1415.member_7 | (_e1415.member_11 & ~(_e1415.member_12))) & ~((_e1415.member_12 & ~(_e1415.member_11))));
phi_3896_ = 15i;
phi_3899_ = 16i;
loop {
let _e1515 = phi_3896_;
let _e1517 = phi_3899_;
local_3 = _e1517;
local_5 = _e1517;
local_6 = _e1517;
local_8 = _e1517;
local_9 = _e1517;
let _e1518 = (_e1515 >= 0i);
if _e1518 {
phi_3897_ = (_e1515 - 1i);
phi_3900_ = select(_e1517, _e1515, (((_e1513 >> bitcast<u32>((_e1515 & 31i))) & 1i) == 1i));
} else {
phi_3897_ = i32();
phi_3900_ = i32();
}
let _e1527 = phi_3897_;
let _e1529 = phi_3900_;
continue;
continuing {
phi_3896_ = _e1527;
phi_3899_ = _e1529;
break if !(_e1518);
}
}
if _e1447 {
let _e1799 = (1f / select(_e1415.member_1.x, select(1e-12f, -1e-12f, (_e1415.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e1415.member_1.x) & 2147483647u)) < 1e-12f)));
let _e1808 = (1f / select(_e1415.member_1.y, select(1e-12f, -1e-12f, (_e1415.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e1415.member_1.y) & 2147483647u)) < 1e-12f)));
let _e1817 = (1f / select(_e1415.member_1.z, select(1e-12f, -1e-12f, (_e1415.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e1415.member_1.z) & 2147483647u)) < 1e-12f)));
let _e1821 = global_5.member.member_13.member_4;
let _e1828 = global_5.member.member_13.member_5;
let _e1834 = ((_e1821.member - _e1415.member.x) * _e1799);
let _e1836 = ((_e1828.member - _e1415.member.x) * _e1799);
let _e1839 = ((_e1821.member_1 - _e1415.member.y) * _e1808);
let _e1841 = ((_e1828.member_1 - _e1415.member.y) * _e1808);
let _e1844 = ((_e1821.member_2 - _e1415.member.z) * _e1817);
let _e1846 = ((_e1828.member_2 - _e1415.member.z) * _e1817);
let _e1848 = select(_e1836, _e1834, (_e1834 < _e1836));
let _e1850 = select(_e1841, _e1839, (_e1839 < _e1841));
let _e1852 = select(_e1850, _e1848, (_e1848 > _e1850));
let _e1854 = select(_e1846, _e1844, (_e1844 < _e1846));
let _e1856 = select(_e1854, _e1852, (_e1852 > _e1854));
let _e1858 = select(_e1836, _e1834, (_e1834 > _e1836));
let _e1860 = select(_e1841, _e1839, (_e1839 > _e1841));
let _e1862 = select(_e1860, _e1858, (_e1858 < _e1860));
let _e1864 = select(_e1846, _e1844, (_e1844 > _e1846));
let _e1866 = select(_e1864, _e1862, (_e1862 < _e1864));
let _e1868 = select(0f, _e1856, (_e1856 > 0f));
let _e1870 = select(_e1415.member_10, _e1866, (_e1866 < _e1415.member_10));
let _e1871 = (_e1870 > _e1868);
let _e1874 = (select(0f, _e1870, _e1871) - select(0f, _e1868, _e1871));
let _e1878 = global_5.member.member_13.member;
let _e1883 = -((_e1878.member * _e1874));
let _e1885 = select(-87f, _e1883, (_e1883 > -87f));
let _e1887 = select(88f, _e1885, (_e1885 < 88f));
let _e1889 = ((_e1887 * 1.442695f) + 0.5f);
let _e1891 = select(-127f, _e1889, (_e1889 > -127f));
let _e1893 = select(128f, _e1891, (_e1891 < 128f));
let _e1900 = select(0i, select(select(i32(_e1893), i32(-2147483648), (_e1893 < -2147483600f)), 2147483647i, (_e1893 > 2147483500f)), (_e1893 == _e1893));
let _e1904 = (_e1900 - select(0i, 1i, (_e1893 < f32(_e1900))));
let _e1905 = f32(_e1904);
let _e1909 = ((_e1887 - (_e1905 * 0.6933594f)) - (_e1905 * -2.1219444e-4f));
let _e1931 = -((_e1878.member_1 * _e1874));
let _e1933 = select(-87f, _e1931, (_e1931 > -87f));
let _e1935 = select(88f, _e1933, (_e1933 < 88f));
let _e1937 = ((_e1935 * 1.442695f) + 0.5f);
let _e1939 = select(-127f, _e1937, (_e1937 > -127f));
let _e1941 = select(128f, _e1939, (_e1939 < 128f));
let _e1948 = select(0i, select(select(i32(_e1941), i32(-2147483648), (_e1941 < -2147483600f)), 2147483647i, (_e1941 > 2147483500f)), (_e1941 == _e1941));
let _e1952 = (_e1948 - select(0i, 1i, (_e1941 < f32(_e1948))));
let _e1953 = f32(_e1952);
let _e1957 = ((_e1935 - (_e1953 * 0.6933594f)) - (_e1953 * -2.1219444e-4f));
let _e1979 = -((_e1878.member_2 * _e1874));
let _e1981 = select(-87f, _e1979, (_e1979 > -87f));
let _e1983 = select(88f, _e1981, (_e1981 < 88f));
let _e1985 = ((_e1983 * 1.442695f) + 0.5f);
let _e1987 = select(-127f, _e1985, (_e1985 > -127f));
let _e1989 = select(128f, _e1987, (_e1987 < 128f));
let _e1996 = select(0i, select(select(i32(_e1989), i32(-2147483648), (_e1989 < -2147483600f)), 2147483647i, (_e1989 > 2147483500f)), (_e1989 == _e1989));
let _e2000 = (_e1996 - select(0i, 1i, (_e1989 < f32(_e1996))));
let _e2001 = f32(_e2000);
let _e2005 = ((_e1983 - (_e2001 * 0.6933594f)) - (_e2001 * -2.1219444e-4f));
let _e2032 = (1f / 3f);
let _e2036 = (_e1415.member_6.x * ((1f + (_e1909 * (1f + (_e1909 * (0.5f + (_e1909 * (0.16666667f + (_e1909 * (0.041666668f + (_e1909 * (0.008333334f + (_e1909 * (0.001388889f + (_e1909 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1904 + 127i)) << bitcast<u32>(23i)))));
let _e2039 = (_e1415.member_6.y * ((1f + (_e1957 * (1f + (_e1957 * (0.5f + (_e1957 * (0.16666667f + (_e1957 * (0.041666668f + (_e1957 * (0.008333334f + (_e1957 * (0.001388889f + (_e1957 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1952 + 127i)) << bitcast<u32>(23i)))));
let _e2042 = (_e1415.member_6.z * ((1f + (_e2005 * (1f + (_e2005 * (0.5f + (_e2005 * (0.16666667f + (_e2005 * (0.041666668f + (_e2005 * (0.008333334f + (_e2005 * (0.001388889f + (_e2005 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2000 + 127i)) << bitcast<u32>(23i)))));
let _e2071 = type_25(_e1415.member, _e1415.member_1, _e1415.member_2, _e1415.member_3, _e1415.member_4, _e1415.member_5, vec3<f32>(_e2036, _e2039, _e2042), _e1415.member_7, _e1415.member_8, _e1415.member_9, _e1415.member_10, _e1415.member_11, _e1415.member_12, _e1415.member_13, _e1415.member_14, _e1415.member_15, _e1415.member_16, _e1415.member_17, _e1415.member_18, _e1415.member_19, _e1415.member_20, _e1415.member_21, _e1415.member_22, _e1415.member_23, _e1415.member_24, _e1415.member_25, _e1415.member_26, _e1415.member_27);
if _e1459 {
phi_4299_ = ((((_e1415.member_6.x + _e1415.member_6.y) + _e1415.member_6.z) * _e2032) - (((_e2036 + _e2039) + _e2042) * _e2032));
} else {
phi_4299_ = 0f;
}
let _e2077 = phi_4299_;
phi_4589_ = type_25(_e2071.member, _e2071.member_1, _e2071.member_2, _e2071.member_3, _e2071.member_4, _e2071.member_5, _e2071.member_6, _e2071.member_7, _e2071.member_8, _e2071.member_9, _e2071.member_10, _e2071.member_11, _e2071.member_12, _e2071.member_13, _e2071.member_14, _e2071.member_15, _e2071.member_16, _e2071.member_17, _e2071.member_18, _e2071.member_19, _e2071.member_20, _e2071.member_21, _e2071.member_22, _e2071.member_23, _e2071.member_24, _e2071.member_25, (_e1415.member_26 + _e2077), _e2071.member_27);
} else {
let _e1532 = select(1e6f, _e1469, (_e1469 < 1e6f));
let _e1534 = local_1;
let _e1535 = (_e1534 * 4i);
let _e1536 = (_e1535 + 1i);
let _e1538 = select(_e1492, _e1536, (_e1536 < _e1492));
let _e1544 = global_3.member[bitcast<u32>(select(0i, _e1538, (_e1538 > 0i)))];
let _e1546 = -((_e1544 * _e1532));
let _e1548 = select(-87f, _e1546, (_e1546 > -87f));
let _e1550 = select(88f, _e1548, (_e1548 < 88f));
let _e1552 = ((_e1550 * 1.442695f) + 0.5f);
let _e1554 = select(-127f, _e1552, (_e1552 > -127f));
let _e1556 = select(128f, _e1554, (_e1554 < 128f));
let _e1563 = select(0i, select(select(i32(_e1556), i32(-2147483648), (_e1556 < -2147483600f)), 2147483647i, (_e1556 > 2147483500f)), (_e1556 == _e1556));
let _e1567 = (_e1563 - select(0i, 1i, (_e1556 < f32(_e1563))));
let _e1568 = f32(_e1567);
let _e1572 = ((_e1550 - (_e1568 * 0.6933594f)) - (_e1568 * -2.1219444e-4f));
let _e1593 = (_e1535 + 2i);
let _e1595 = select(_e1492, _e1593, (_e1593 < _e1492));
let _e1601 = global_3.member[bitcast<u32>(select(0i, _e1595, (_e1595 > 0i)))];
let _e1603 = -((_e1601 * _e1532));
let _e1605 = select(-87f, _e1603, (_e1603 > -87f));
let _e1607 = select(88f, _e1605, (_e1605 < 88f));
let _e1609 = ((_e1607 * 1.442695f) + 0.5f);
let _e1611 = select(-127f, _e1609, (_e1609 > -127f));
let _e1613 = select(128f, _e1611, (_e1611 < 128f));
let _e1620 = select(0i, select(select(i32(_e1613), i32(-2147483648), (_e1613 < -2147483600f)), 2147483647i, (_e1613 > 2147483500f)), (_e1613 == _e1613));
let _e1624 = (_e1620 - select(0i, 1i, (_e1613 < f32(_e1620))));
let _e1625 = f32(_e1624);
let _e1629 = ((_e1607 - (_e1625 * 0.6933594f)) - (_e1625 * -2.1219444e-4f));
let _e1650 = (_e1535 + 3i);
let _e1652 = select(_e1492, _e1650, (_e1650 < _e1492));
let _e1658 = global_3.member[bitcast<u32>(select(0i, _e1652, (_e1652 > 0i)))];
let _e1660 = -((_e1658 * _e1532));
let _e1662 = select(-87f, _e1660, (_e1660 > -87f));
let _e1664 = select(88f, _e1662, (_e1662 < 88f));
let _e1666 = ((_e1664 * 1.442695f) + 0.5f);
let _e1668 = select(-127f, _e1666, (_e1666 > -127f));
let _e1670 = select(128f, _e1668, (_e1668 < 128f));
let _e1677 = select(0i, select(select(i32(_e1670), i32(-2147483648), (_e1670 < -2147483600f)), 2147483647i, (_e1670 > 2147483500f)), (_e1670 == _e1670));
let _e1681 = (_e1677 - select(0i, 1i, (_e1670 < f32(_e1677))));
let _e1682 = f32(_e1681);
let _e1686 = ((_e1664 - (_e1682 * 0.6933594f)) - (_e1682 * -2.1219444e-4f));
let _e1713 = (1f / 3f);
let _e1717 = (_e1415.member_6.x * ((1f + (_e1572 * (1f + (_e1572 * (0.5f + (_e1572 * (0.16666667f + (_e1572 * (0.041666668f + (_e1572 * (0.008333334f + (_e1572 * (0.001388889f + (_e1572 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1567 + 127i)) << bitcast<u32>(23i)))));
let _e1720 = (_e1415.member_6.y * ((1f + (_e1629 * (1f + (_e1629 * (0.5f + (_e1629 * (0.16666667f + (_e1629 * (0.041666668f + (_e1629 * (0.008333334f + (_e1629 * (0.001388889f + (_e1629 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1624 + 127i)) << bitcast<u32>(23i)))));
let _e1723 = (_e1415.member_6.z * ((1f + (_e1686 * (1f + (_e1686 * (0.5f + (_e1686 * (0.16666667f + (_e1686 * (0.041666668f + (_e1686 * (0.008333334f + (_e1686 * (0.001388889f + (_e1686 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1681 + 127i)) << bitcast<u32>(23i)))));
let _e1752 = type_25(_e1415.member, _e1415.member_1, _e1415.member_2, _e1415.member_3, _e1415.member_4, _e1415.member_5, vec3<f32>(_e1717, _e1720, _e1723), _e1415.member_7, _e1415.member_8, _e1415.member_9, _e1415.member_10, _e1415.member_11, _e1415.member_12, _e1415.member_13, _e1415.member_14, _e1415.member_15, _e1415.member_16, _e1415.member_17, _e1415.member_18, _e1415.member_19, _e1415.member_20, _e1415.member_21, _e1415.member_22, _e1415.member_23, _e1415.member_24, _e1415.member_25, _e1415.member_26, _e1415.member_27);
if _e1459 {
phi_4585_ = ((((_e1415.member_6.x + _e1415.member_6.y) + _e1415.member_6.z) * _e1713) - (((_e1717 + _e1720) + _e1723) * _e1713));
} else {
phi_4585_ = 0f;
}
let _e1758 = phi_4585_;
phi_4589_ = type_25(_e1752.member, _e1752.member_1, _e1752.member_2, _e1752.member_3, _e1752.member_4, _e1752.member_5, _e1752.member_6, _e1752.member_7, _e1752.member_8, _e1752.member_9, _e1752.member_10, _e1752.member_11, _e1752.member_12, _e1752.member_13, _e1752.member_14, _e1752.member_15, _e1752.member_16, _e1752.member_17, _e1752.member_18, _e1752.member_19, _e1752.member_20, _e1752.member_21, _e1752.member_22, _e1752.member_23, _e1752.member_24, (_e1415.member_25 + _e1758), _e1752.member_26, _e1752.member_27);
}
let _e2109 = phi_4589_;
if (!(_e1464) || (_e1504 && (_e1502 == 0f))) {
if (bitcast<i32>(countOneBits(bitcast<u32>((_e2109.member_17 & ((1i << bitcast<u32>((_e2109.member_16 & 31i))) - 1i))))) == _e2109.member_20) {
phi_4643_ = (((_e2109.member_6.x + _e2109.member_6.y) + _e2109.member_6.z) * (1f / 3f));
} else {
phi_4643_ = 0f;
}
let _e5828 = phi_4643_;
if (_e2109.member_9 == -1i) {
phi_4655_ = type_25(_e2109.member, _e2109.member_1, _e2109.member_2, _e2109.member_3, _e2109.member_4, _e2109.member_5, _e2109.member_6, _e2109.member_7, _e2109.member_8, _e2109.member_9, _e2109.member_10, _e2109.member_11, _e2109.member_12, _e2109.member_13, _e2109.member_14, _e2109.member_15, _e2109.member_16, _e2109.member_17, _e2109.member_18, _e2109.member_19, _e2109.member_20, _e2109.member_21, _e2109.member_22, (_e2109.member_23 + _e5828), _e2109.member_24, _e2109.member_25, _e2109.member_26, _e2109.member_27);
} else {
phi_4655_ = type_25(_e2109.member, _e2109.member_1, _e2109.member_2, _e2109.member_3, _e2109.member_4, _e2109.member_5, _e2109.member_6, _e2109.member_7, _e2109.member_8, _e2109.member_9, _e2109.member_10, _e2109.member_11, _e2109.member_12, _e2109.member_13, _e2109.member_14, _e2109.member_15, _e2109.member_16, _e2109.member_17, _e2109.member_18, _e2109.member_19, _e2109.member_20, _e2109.member_21, _e2109.member_22, _e2109.member_23, (_e2109.member_24 + _e5828), _e2109.member_25, _e2109.member_26, _e2109.member_27);
}
let _e5892 = phi_4655_;
let _e5894 = (_e5892.member_18 == 0i);
if (_e5894 && (_e5892.member_21 == 0i)) {
phi_5959_ = type_25(_e5892.member, _e5892.member_1, _e5892.member_2, _e5892.member_3, _e5892.member_4, _e5892.member_5, _e5892.member_6, _e5892.member_7, _e5892.member_8, _e5892.member_9, _e5892.member_10, _e5892.member_11, _e5892.member_12, _e5892.member_13, _e5892.member_14, 3f, _e5892.member_16, _e5892.member_17, _e5892.member_18, _e5892.member_19, _e5892.member_20, _e5892.member_21, _e5892.member_22, _e5892.member_23, _e5892.member_24, _e5892.member_25, _e5892.member_26, _e5892.member_27);
} else {
if _e5894 {
let _e6026 = type_25(_e5892.member, _e5892.member_1, _e5892.member_2, _e5892.member_3, _e5892.member_4, _e5892.member_5, _e5892.member_6, _e5892.member_7, _e5892.member_8, _e5892.member_9, _e5892.member_10, _e5892.member_11, _e5892.member_12, _e5892.member_13, _e5892.member_14, _e5892.member_15, _e5892.member_16, _e5892.member_17, _e5892.member_18, _e5892.member_19, (_e5892.member_20 + 1i), _e5892.member_21, _e5892.member_22, _e5892.member_23, _e5892.member_24, _e5892.member_25, _e5892.member_26, _e5892.member_27);
let _e6054 = type_25(_e6026.member, _e6026.member_1, _e6026.member_2, _e6026.member_3, _e6026.member_4, _e6026.member_5, _e6026.member_6, _e6026.member_7, _e6026.member_8, _e6026.member_9, _e6026.member_10, _e6026.member_11, _e6026.member_12, _e6026.member_13, _e6026.member_14, _e6026.member_15, _e6026.member_16, _e6026.member_17, _e6026.member_18, _e6026.member_19, _e6026.member_20, 0i, _e6026.member_22, _e6026.member_23, _e6026.member_24, _e6026.member_25, _e6026.member_26, _e6026.member_27);
let _e6082 = type_25(_e6054.member, _e6054.member_1, _e6054.member_2, _e6054.member_3, _e6054.member_4, _e6054.member_5, _e6054.member_6, _e6054.member_7, _e6054.member_8, _e6054.member_9, _e6054.member_10, _e6054.member_11, _e6054.member_12, _e6054.member_13, _e6054.member_14, _e6054.member_15, _e6054.member_16, 0i, _e6054.member_18, _e6054.member_19, _e6054.member_20, _e6054.member_21, _e6054.member_22, _e6054.member_23, _e6054.member_24, _e6054.member_25, _e6054.member_26, _e6054.member_27);
phi_4696_ = type_25(_e6082.member, _e6082.member_1, _e6082.member_2, _e6082.member_3, _e6082.member_4, _e6082.member_5, _e6082.member_6, _e6082.member_7, _e6082.member_8, _e6082.member_9, _e6082.member_10, _e6082.member_11, _e6082.member_12, _e6082.member_13, _e6082.member_14, _e6082.member_15, _e6082.member_16, _e6082.member_17, _e6082.member_18, 0i, _e6082.member_20, _e6082.member_21, _e6082.member_22, _e6082.member_23, _e6082.member_24, _e6082.member_25, _e6082.member_26, _e6082.member_27);
} else {
let _e5902 = bitcast<i32>((bitcast<u32>(f32(_e5892.member_18)) >> bitcast<u32>(23i)));
let _e5906 = (1i << bitcast<u32>(((_e5902 - 127i) & 31i)));
let _e5907 = (_e5906 - 1i);
let _e5938 = type_25(_e5892.member, _e5892.member_1, _e5892.member_2, _e5892.member_3, _e5892.member_4, _e5892.member_5, _e5892.member_6, _e5892.member_7, _e5892.member_8, _e5892.member_9, _e5892.member_10, _e5892.member_11, _e5892.member_12, _e5892.member_13, _e5892.member_14, _e5892.member_15, _e5892.member_16, ((_e5892.member_17 & _e5907) | _e5906), _e5892.member_18, _e5892.member_19, _e5892.member_20, _e5892.member_21, _e5892.member_22, _e5892.member_23, _e5892.member_24, _e5892.member_25, _e5892.member_26, _e5892.member_27);
let _e5967 = type_25(_e5938.member, _e5938.member_1, _e5938.member_2, _e5938.member_3, _e5938.member_4, _e5938.member_5, _e5938.member_6, _e5938.member_7, _e5938.member_8, _e5938.member_9, _e5938.member_10, _e5938.member_11, _e5938.member_12, _e5938.member_13, _e5938.member_14, _e5938.member_15, _e5938.member_16, _e5938.member_17, (_e5892.member_18 & _e5907), _e5938.member_19, _e5938.member_20, _e5938.member_21, _e5938.member_22, _e5938.member_23, _e5938.member_24, _e5938.member_25, _e5938.member_26, _e5938.member_27);
phi_4696_ = type_25(_e5967.member, _e5967.member_1, _e5967.member_2, _e5967.member_3, _e5967.member_4, _e5967.member_5, _e5967.member_6, _e5967.member_7, _e5967.member_8, _e5967.member_9, _e5967.member_10, _e5967.member_11, _e5967.member_12, _e5967.member_13, _e5967.member_14, _e5967.member_15, _e5967.member_16, _e5967.member_17, _e5967.member_18, (_e5902 + -126i), _e5967.member_20, _e5967.member_21, _e5967.member_22, _e5967.member_23, _e5967.member_24, _e5967.member_25, _e5967.member_26, _e5967.member_27);
}
let _e6112 = phi_4696_;
let _e6118 = global_5.member.member_1.member;
let _e6120 = f32(bitcast<i32>(_e6118));
let _e6124 = global_5.member.member_1.member_1;
let _e6126 = f32(bitcast<i32>(_e6124));
let _e6136 = global_5.member.member_2.member;
let _e6137 = (((((f32(bitcast<i32>(_e121.x)) + 0.5f) / _e6120) * 2f) - 1f) * _e6136);
let _e6145 = global_5.member.member_2.member_1;
let _e6146 = ((1f - (((f32(bitcast<i32>(_e121.y)) + 0.5f) / _e6126) * 2f)) * _e6145);
let _e6149 = global_5.member.member_3;
let _e6158 = global_5.member.member_4;
let _e6165 = ((_e6149.member * _e6137) + (_e6158.member * _e6146));
let _e6166 = ((_e6149.member_1 * _e6137) + (_e6158.member_1 * _e6146));
let _e6167 = ((_e6149.member_2 * _e6137) + (_e6158.member_2 * _e6146));
let _e6171 = global_5.member.member_2.member_3;
let _e6172 = (_e6171 != 0u);
let _e6175 = global_5.member.member_5;
let _e6182 = select((_e6175.member + _e6165), _e6175.member, _e6172);
let _e6183 = select((_e6175.member_1 + _e6166), _e6175.member_1, _e6172);
let _e6184 = select((_e6175.member_2 + _e6167), _e6175.member_2, _e6172);
let _e6187 = global_5.member.member_6;
let _e6194 = select(_e6187.member, (_e6187.member + _e6165), _e6172);
let _e6195 = select(_e6187.member_1, (_e6187.member_1 + _e6166), _e6172);
let _e6196 = select(_e6187.member_2, (_e6187.member_2 + _e6167), _e6172);
let _e6202 = (((_e6182 * _e6182) + (_e6183 * _e6183)) + (_e6184 * _e6184));
let _e6206 = (1f / sqrt(select(0f, _e6202, (_e6202 > 0f))));
let _e6207 = (_e6182 * _e6206);
let _e6208 = (_e6183 * _e6206);
let _e6209 = (_e6184 * _e6206);
let _e6212 = ((2f * _e6136) / _e6120);
let _e6213 = (_e6149.member * _e6212);
let _e6214 = (_e6149.member_1 * _e6212);
let _e6215 = (_e6149.member_2 * _e6212);
let _e6217 = ((-2f * _e6145) / _e6126);
let _e6218 = (_e6158.member * _e6217);
let _e6219 = (_e6158.member_1 * _e6217);
let _e6220 = (_e6158.member_2 * _e6217);
let _e6233 = (((_e6213 * _e6207) + (_e6214 * _e6208)) + (_e6215 * _e6209));
let _e6243 = select(((_e6213 - (_e6207 * _e6233)) * _e6206), 0f, _e6172);
let _e6244 = select(((_e6214 - (_e6208 * _e6233)) * _e6206), 0f, _e6172);
let _e6245 = select(((_e6215 - (_e6209 * _e6233)) * _e6206), 0f, _e6172);
let _e6251 = (((_e6218 * _e6207) + (_e6219 * _e6208)) + (_e6220 * _e6209));
let _e6261 = select(((_e6218 - (_e6207 * _e6251)) * _e6206), 0f, _e6172);
let _e6262 = select(((_e6219 - (_e6208 * _e6251)) * _e6206), 0f, _e6172);
let _e6263 = select(((_e6220 - (_e6209 * _e6251)) * _e6206), 0f, _e6172);
let _e6272 = (1f / select(_e6207, select(1e-12f, -1e-12f, (_e6207 < 0f)), (bitcast<f32>((bitcast<u32>(_e6207) & 2147483647u)) < 1e-12f)));
let _e6280 = (1f / select(_e6208, select(1e-12f, -1e-12f, (_e6208 < 0f)), (bitcast<f32>((bitcast<u32>(_e6208) & 2147483647u)) < 1e-12f)));
let _e6288 = (1f / select(_e6209, select(1e-12f, -1e-12f, (_e6209 < 0f)), (bitcast<f32>((bitcast<u32>(_e6209) & 2147483647u)) < 1e-12f)));
let _e6291 = global_5.member.member_8;
let _e6297 = global_5.member.member_9;
let _e6302 = ((_e6291.member - _e6194) * _e6272);
let _e6304 = ((_e6297.member - _e6194) * _e6272);
let _e6306 = ((_e6291.member_1 - _e6195) * _e6280);
let _e6308 = ((_e6297.member_1 - _e6195) * _e6280);
let _e6310 = ((_e6291.member_2 - _e6196) * _e6288);
let _e6312 = ((_e6297.member_2 - _e6196) * _e6288);
let _e6314 = select(_e6304, _e6302, (_e6302 < _e6304));
let _e6316 = select(_e6308, _e6306, (_e6306 < _e6308));
let _e6318 = select(_e6316, _e6314, (_e6314 > _e6316));
let _e6320 = select(_e6312, _e6310, (_e6310 < _e6312));
let _e6322 = select(_e6320, _e6318, (_e6318 > _e6320));
let _e6324 = select(_e6304, _e6302, (_e6302 > _e6304));
let _e6326 = select(_e6308, _e6306, (_e6306 > _e6308));
let _e6328 = select(_e6326, _e6324, (_e6324 < _e6326));
let _e6330 = select(_e6312, _e6310, (_e6310 > _e6312));
let _e6334 = select(0f, _e6322, (_e6322 > 0f));
let _e6339 = global_5.member.member_14.member.member;
let _e6350 = ((((_e6339.member.member * _e6194) + (_e6339.member.member_1 * _e6195)) + (_e6339.member.member_2 * _e6196)) + _e6339.member_1);
let _e6356 = -((((_e6339.member.member * _e6207) + (_e6339.member.member_1 * _e6208)) + (_e6339.member.member_2 * _e6209)));
let _e6358 = (_e6356 > 1e-9f);
let _e6360 = select(1e-9f, _e6356, _e6358);
let _e6362 = ((_e6350 / _e6360) - 0.015625f);
let _e6365 = select(1e30f, select(0f, _e6362, (_e6362 > 0f)), ((_e6350 > 0f) && _e6358));
let _e6370 = global_5.member.member_14.member_1.member;
let _e6381 = ((((_e6370.member.member * _e6194) + (_e6370.member.member_1 * _e6195)) + (_e6370.member.member_2 * _e6196)) + _e6370.member_1);
let _e6387 = -((((_e6370.member.member * _e6207) + (_e6370.member.member_1 * _e6208)) + (_e6370.member.member_2 * _e6209)));
let _e6389 = (_e6387 > 1e-9f);
let _e6391 = select(1e-9f, _e6387, _e6389);
let _e6393 = ((_e6381 / _e6391) - 0.015625f);
let _e6396 = select(1e30f, select(0f, _e6393, (_e6393 > 0f)), ((_e6381 > 0f) && _e6389));
let _e6402 = ((select(_e6330, _e6328, (_e6328 < _e6330)) <= _e6334) || (true && (select(_e6365, _e6396, (_e6396 < _e6365)) <= _e6334)));
let _e6403 = select(_e6334, 0f, _e6402);
let _e6404 = (_e6207 * _e6403);
let _e6405 = (_e6208 * _e6403);
let _e6406 = (_e6209 * _e6403);
let _e6407 = (_e6194 + _e6404);
let _e6408 = (_e6195 + _e6405);
let _e6409 = (_e6196 + _e6406);
let _e6439 = type_25((vec3<f32>(_e6194, _e6195, _e6196) + vec3<f32>(_e6404, _e6405, _e6406)), _e6112.member_1, _e6112.member_2, _e6112.member_3, _e6112.member_4, _e6112.member_5, _e6112.member_6, _e6112.member_7, _e6112.member_8, _e6112.member_9, _e6112.member_10, _e6112.member_11, _e6112.member_12, _e6112.member_13, _e6112.member_14, _e6112.member_15, _e6112.member_16, _e6112.member_17, _e6112.member_18, _e6112.member_19, _e6112.member_20, _e6112.member_21, _e6112.member_22, _e6112.member_23, _e6112.member_24, _e6112.member_25, _e6112.member_26, _e6112.member_27);
let _e6467 = type_25(_e6439.member, vec3<f32>(_e6207, _e6208, _e6209), _e6439.member_2, _e6439.member_3, _e6439.member_4, _e6439.member_5, _e6439.member_6, _e6439.member_7, _e6439.member_8, _e6439.member_9, _e6439.member_10, _e6439.member_11, _e6439.member_12, _e6439.member_13, _e6439.member_14, _e6439.member_15, _e6439.member_16, _e6439.member_17, _e6439.member_18, _e6439.member_19, _e6439.member_20, _e6439.member_21, _e6439.member_22, _e6439.member_23, _e6439.member_24, _e6439.member_25, _e6439.member_26, _e6439.member_27);
let _e6505 = type_25(_e6467.member, _e6467.member_1, (vec3<f32>(select(0f, _e6213, _e6172), select(0f, _e6214, _e6172), select(0f, _e6215, _e6172)) + vec3<f32>((_e6243 * _e6403), (_e6244 * _e6403), (_e6245 * _e6403))), _e6467.member_3, _e6467.member_4, _e6467.member_5, _e6467.member_6, _e6467.member_7, _e6467.member_8, _e6467.member_9, _e6467.member_10, _e6467.member_11, _e6467.member_12, _e6467.member_13, _e6467.member_14, _e6467.member_15, _e6467.member_16, _e6467.member_17, _e6467.member_18, _e6467.member_19, _e6467.member_20, _e6467.member_21, _e6467.member_22, _e6467.member_23, _e6467.member_24, _e6467.member_25, _e6467.member_26, _e6467.member_27);
let _e6533 = type_25(_e6505.member, _e6505.member_1, _e6505.member_2, (vec3<f32>(select(0f, _e6218, _e6172), select(0f, _e6219, _e6172), select(0f, _e6220, _e6172)) + vec3<f32>((_e6261 * _e6403), (_e6262 * _e6403), (_e6263 * _e6403))), _e6505.member_4, _e6505.member_5, _e6505.member_6, _e6505.member_7, _e6505.member_8, _e6505.member_9, _e6505.member_10, _e6505.member_11, _e6505.member_12, _e6505.member_13, _e6505.member_14, _e6505.member_15, _e6505.member_16, _e6505.member_17, _e6505.member_18, _e6505.member_19, _e6505.member_20, _e6505.member_21, _e6505.member_22, _e6505.member_23, _e6505.member_24, _e6505.member_25, _e6505.member_26, _e6505.member_27);
let _e6561 = type_25(_e6533.member, _e6533.member_1, _e6533.member_2, _e6533.member_3, vec3<f32>(_e6243, _e6244, _e6245), _e6533.member_5, _e6533.member_6, _e6533.member_7, _e6533.member_8, _e6533.member_9, _e6533.member_10, _e6533.member_11, _e6533.member_12, _e6533.member_13, _e6533.member_14, _e6533.member_15, _e6533.member_16, _e6533.member_17, _e6533.member_18, _e6533.member_19, _e6533.member_20, _e6533.member_21, _e6533.member_22, _e6533.member_23, _e6533.member_24, _e6533.member_25, _e6533.member_26, _e6533.member_27);
let _e6589 = type_25(_e6561.member, _e6561.member_1, _e6561.member_2, _e6561.member_3, _e6561.member_4, vec3<f32>(_e6261, _e6262, _e6263), _e6561.member_6, _e6561.member_7, _e6561.member_8, _e6561.member_9, _e6561.member_10, _e6561.member_11, _e6561.member_12, _e6561.member_13, _e6561.member_14, _e6561.member_15, _e6561.member_16, _e6561.member_17, _e6561.member_18, _e6561.member_19, _e6561.member_20, _e6561.member_21, _e6561.member_22, _e6561.member_23, _e6561.member_24, _e6561.member_25, _e6561.member_26, _e6561.member_27);
let _e6617 = type_25(_e6589.member, _e6589.member_1, _e6589.member_2, _e6589.member_3, _e6589.member_4, _e6589.member_5, _e6589.member_6, 0i, _e6589.member_8, _e6589.member_9, _e6589.member_10, _e6589.member_11, _e6589.member_12, _e6589.member_13, _e6589.member_14, _e6589.member_15, _e6589.member_16, _e6589.member_17, _e6589.member_18, _e6589.member_19, _e6589.member_20, _e6589.member_21, _e6589.member_22, _e6589.member_23, _e6589.member_24, _e6589.member_25, _e6589.member_26, _e6589.member_27);
let _e6645 = type_25(_e6617.member, _e6617.member_1, _e6617.member_2, _e6617.member_3, _e6617.member_4, _e6617.member_5, _e6617.member_6, _e6617.member_7, _e6617.member_8, _e6617.member_9, _e6617.member_10, _e6617.member_11, _e6617.member_12, _e6617.member_13, _e6617.member_14, _e6617.member_15, 0i, _e6617.member_17, _e6617.member_18, _e6617.member_19, _e6617.member_20, _e6617.member_21, _e6617.member_22, _e6617.member_23, _e6617.member_24, _e6617.member_25, _e6617.member_26, _e6617.member_27);
let _e6673 = type_25(_e6645.member, _e6645.member_1, _e6645.member_2, _e6645.member_3, _e6645.member_4, _e6645.member_5, _e6645.member_6, _e6645.member_7, _e6645.member_8, _e6645.member_9, _e6645.member_10, _e6645.member_11, _e6645.member_12, _e6645.member_13, _e6645.member_14, 1f, _e6645.member_16, _e6645.member_17, _e6645.member_18, _e6645.member_19, _e6645.member_20, _e6645.member_21, _e6645.member_22, _e6645.member_23, _e6645.member_24, _e6645.member_25, _e6645.member_26, _e6645.member_27);
let _e6701 = type_25(_e6673.member, _e6673.member_1, _e6673.member_2, _e6673.member_3, _e6673.member_4, _e6673.member_5, _e6673.member_6, _e6673.member_7, _e6673.member_8, _e6673.member_9, _e6673.member_10, _e6673.member_11, _e6673.member_12, 0f, _e6673.member_14, _e6673.member_15, _e6673.member_16, _e6673.member_17, _e6673.member_18, _e6673.member_19, _e6673.member_20, _e6673.member_21, _e6673.member_22, _e6673.member_23, _e6673.member_24, _e6673.member_25, _e6673.member_26, _e6673.member_27);
let _e6729 = type_25(_e6701.member, _e6701.member_1, _e6701.member_2, _e6701.member_3, _e6701.member_4, _e6701.member_5, _e6701.member_6, _e6701.member_7, _e6701.member_8, _e6701.member_9, _e6701.member_10, 0i, _e6701.member_12, _e6701.member_13, _e6701.member_14, _e6701.member_15, _e6701.member_16, _e6701.member_17, _e6701.member_18, _e6701.member_19, _e6701.member_20, _e6701.member_21, _e6701.member_22, _e6701.member_23, _e6701.member_24, _e6701.member_25, _e6701.member_26, _e6701.member_27);
let _e6757 = type_25(_e6729.member, _e6729.member_1, _e6729.member_2, _e6729.member_3, _e6729.member_4, _e6729.member_5, _e6729.member_6, _e6729.member_7, _e6729.member_8, _e6729.member_9, _e6729.member_10, _e6729.member_11, 0i, _e6729.member_13, _e6729.member_14, _e6729.member_15, _e6729.member_16, _e6729.member_17, _e6729.member_18, _e6729.member_19, _e6729.member_20, _e6729.member_21, _e6729.member_22, _e6729.member_23, _e6729.member_24, _e6729.member_25, _e6729.member_26, _e6729.member_27);
let _e6763 = ((((_e6339.member.member * _e6407) + (_e6339.member.member_1 * _e6408)) + (_e6339.member.member_2 * _e6409)) + _e6339.member_1);
let _e6767 = ((_e6763 / _e6360) - 0.015625f);
let _e6770 = select(1e30f, select(0f, _e6767, (_e6767 > 0f)), ((_e6763 > 0f) && _e6358));
let _e6776 = ((((_e6370.member.member * _e6407) + (_e6370.member.member_1 * _e6408)) + (_e6370.member.member_2 * _e6409)) + _e6370.member_1);
let _e6780 = ((_e6776 / _e6391) - 0.015625f);
let _e6783 = select(1e30f, select(0f, _e6780, (_e6780 > 0f)), ((_e6776 > 0f) && _e6389));
let _e6787 = (_e6783 < _e6770);
let _e6818 = type_25(_e6757.member, _e6757.member_1, _e6757.member_2, _e6757.member_3, _e6757.member_4, _e6757.member_5, _e6757.member_6, _e6757.member_7, 0i, _e6757.member_9, _e6757.member_10, _e6757.member_11, _e6757.member_12, _e6757.member_13, _e6757.member_14, _e6757.member_15, _e6757.member_16, _e6757.member_17, _e6757.member_18, _e6757.member_19, _e6757.member_20, _e6757.member_21, _e6757.member_22, _e6757.member_23, _e6757.member_24, _e6757.member_25, _e6757.member_26, _e6757.member_27);
let _e6846 = type_25(_e6818.member, _e6818.member_1, _e6818.member_2, _e6818.member_3, _e6818.member_4, _e6818.member_5, _e6818.member_6, _e6818.member_7, _e6818.member_8, select(select(-2i, -3i, _e6787), -1i, ((_e6770 >= 1e30f) && (_e6783 >= 1e30f))), _e6818.member_10, _e6818.member_11, _e6818.member_12, _e6818.member_13, _e6818.member_14, _e6818.member_15, _e6818.member_16, _e6818.member_17, _e6818.member_18, _e6818.member_19, _e6818.member_20, _e6818.member_21, _e6818.member_22, _e6818.member_23, _e6818.member_24, _e6818.member_25, _e6818.member_26, _e6818.member_27);
let _e6874 = type_25(_e6846.member, _e6846.member_1, _e6846.member_2, _e6846.member_3, _e6846.member_4, _e6846.member_5, _e6846.member_6, _e6846.member_7, _e6846.member_8, _e6846.member_9, select(_e6770, _e6783, _e6787), _e6846.member_11, _e6846.member_12, _e6846.member_13, _e6846.member_14, _e6846.member_15, _e6846.member_16, _e6846.member_17, _e6846.member_18, _e6846.member_19, _e6846.member_20, _e6846.member_21, _e6846.member_22, _e6846.member_23, _e6846.member_24, _e6846.member_25, _e6846.member_26, _e6846.member_27);
let _e6878 = global_5.member.member_13.member_4;
let _e6885 = global_5.member.member_13.member_5;
let _e6890 = ((_e6878.member - _e6194) * _e6272);
let _e6892 = ((_e6885.member - _e6194) * _e6272);
let _e6894 = ((_e6878.member_1 - _e6195) * _e6280);
let _e6896 = ((_e6885.member_1 - _e6195) * _e6280);
let _e6898 = ((_e6878.member_2 - _e6196) * _e6288);
let _e6900 = ((_e6885.member_2 - _e6196) * _e6288);
let _e6902 = select(_e6892, _e6890, (_e6890 < _e6892));
let _e6904 = select(_e6896, _e6894, (_e6894 < _e6896));
let _e6906 = select(_e6904, _e6902, (_e6902 > _e6904));
let _e6908 = select(_e6900, _e6898, (_e6898 < _e6900));
let _e6910 = select(_e6908, _e6906, (_e6906 > _e6908));
let _e6912 = select(_e6892, _e6890, (_e6890 > _e6892));
let _e6914 = select(_e6896, _e6894, (_e6894 > _e6896));
let _e6916 = select(_e6914, _e6912, (_e6912 < _e6914));
let _e6918 = select(_e6900, _e6898, (_e6898 > _e6900));
let _e6920 = select(_e6918, _e6916, (_e6916 < _e6918));
let _e6922 = select(0f, _e6910, (_e6910 > 0f));
let _e6924 = select(_e6403, _e6920, (_e6920 < _e6403));
let _e6925 = (_e6924 > _e6922);
let _e6928 = (select(0f, _e6924, _e6925) - select(0f, _e6922, _e6925));
let _e6932 = global_5.member.member_13.member;
let _e6937 = -((_e6932.member * _e6928));
let _e6939 = select(-87f, _e6937, (_e6937 > -87f));
let _e6941 = select(88f, _e6939, (_e6939 < 88f));
let _e6943 = ((_e6941 * 1.442695f) + 0.5f);
let _e6945 = select(-127f, _e6943, (_e6943 > -127f));
let _e6947 = select(128f, _e6945, (_e6945 < 128f));
let _e6954 = select(0i, select(select(i32(_e6947), i32(-2147483648), (_e6947 < -2147483600f)), 2147483647i, (_e6947 > 2147483500f)), (_e6947 == _e6947));
let _e6958 = (_e6954 - select(0i, 1i, (_e6947 < f32(_e6954))));
let _e6959 = f32(_e6958);
let _e6963 = ((_e6941 - (_e6959 * 0.6933594f)) - (_e6959 * -2.1219444e-4f));
let _e6985 = -((_e6932.member_1 * _e6928));
let _e6987 = select(-87f, _e6985, (_e6985 > -87f));
let _e6989 = select(88f, _e6987, (_e6987 < 88f));
let _e6991 = ((_e6989 * 1.442695f) + 0.5f);
let _e6993 = select(-127f, _e6991, (_e6991 > -127f));
let _e6995 = select(128f, _e6993, (_e6993 < 128f));
let _e7002 = select(0i, select(select(i32(_e6995), i32(-2147483648), (_e6995 < -2147483600f)), 2147483647i, (_e6995 > 2147483500f)), (_e6995 == _e6995));
let _e7006 = (_e7002 - select(0i, 1i, (_e6995 < f32(_e7002))));
let _e7007 = f32(_e7006);
let _e7011 = ((_e6989 - (_e7007 * 0.6933594f)) - (_e7007 * -2.1219444e-4f));
let _e7033 = -((_e6932.member_2 * _e6928));
let _e7035 = select(-87f, _e7033, (_e7033 > -87f));
let _e7037 = select(88f, _e7035, (_e7035 < 88f));
let _e7039 = ((_e7037 * 1.442695f) + 0.5f);
let _e7041 = select(-127f, _e7039, (_e7039 > -127f));
let _e7043 = select(128f, _e7041, (_e7041 < 128f));
let _e7050 = select(0i, select(select(i32(_e7043), i32(-2147483648), (_e7043 < -2147483600f)), 2147483647i, (_e7043 > 2147483500f)), (_e7043 == _e7043));
let _e7054 = (_e7050 - select(0i, 1i, (_e7043 < f32(_e7050))));
let _e7055 = f32(_e7054);
let _e7059 = ((_e7037 - (_e7055 * 0.6933594f)) - (_e7055 * -2.1219444e-4f));
let _e7082 = (1f / 3f);
let _e7084 = (1f * ((1f + (_e6963 * (1f + (_e6963 * (0.5f + (_e6963 * (0.16666667f + (_e6963 * (0.041666668f + (_e6963 * (0.008333334f + (_e6963 * (0.001388889f + (_e6963 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6958 + 127i)) << bitcast<u32>(23i)))));
let _e7085 = (1f * ((1f + (_e7011 * (1f + (_e7011 * (0.5f + (_e7011 * (0.16666667f + (_e7011 * (0.041666668f + (_e7011 * (0.008333334f + (_e7011 * (0.001388889f + (_e7011 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7006 + 127i)) << bitcast<u32>(23i)))));
let _e7086 = (1f * ((1f + (_e7059 * (1f + (_e7059 * (0.5f + (_e7059 * (0.16666667f + (_e7059 * (0.041666668f + (_e7059 * (0.008333334f + (_e7059 * (0.001388889f + (_e7059 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7054 + 127i)) << bitcast<u32>(23i)))));
let _e7115 = type_25(_e6874.member, _e6874.member_1, _e6874.member_2, _e6874.member_3, _e6874.member_4, _e6874.member_5, vec3<f32>(_e7084, _e7085, _e7086), _e6874.member_7, _e6874.member_8, _e6874.member_9, _e6874.member_10, _e6874.member_11, _e6874.member_12, _e6874.member_13, _e6874.member_14, _e6874.member_15, _e6874.member_16, _e6874.member_17, _e6874.member_18, _e6874.member_19, _e6874.member_20, _e6874.member_21, _e6874.member_22, _e6874.member_23, _e6874.member_24, _e6874.member_25, _e6874.member_26, _e6874.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e6112.member_20) {
phi_5931_ = ((((1f + 1f) + 1f) * _e7082) - (((_e7084 + _e7085) + _e7086) * _e7082));
} else {
phi_5931_ = 0f;
}
let _e7125 = phi_5931_;
let _e7155 = type_25(_e7115.member, _e7115.member_1, _e7115.member_2, _e7115.member_3, _e7115.member_4, _e7115.member_5, _e7115.member_6, _e7115.member_7, _e7115.member_8, _e7115.member_9, _e7115.member_10, _e7115.member_11, _e7115.member_12, _e7115.member_13, _e7115.member_14, _e7115.member_15, _e7115.member_16, _e7115.member_17, _e7115.member_18, _e7115.member_19, _e7115.member_20, _e7115.member_21, _e7115.member_22, _e7115.member_23, _e7115.member_24, _e7115.member_25, (_e6112.member_26 + _e7125), _e7115.member_27);
if _e6402 {
phi_5958_ = type_25(_e7155.member, _e7155.member_1, _e7155.member_2, _e7155.member_3, _e7155.member_4, _e7155.member_5, _e7155.member_6, _e7155.member_7, _e1381, _e7155.member_9, _e7155.member_10, _e7155.member_11, _e7155.member_12, _e7155.member_13, _e7155.member_14, _e7155.member_15, _e7155.member_16, _e7155.member_17, _e7155.member_18, _e7155.member_19, _e7155.member_20, _e7155.member_21, _e7155.member_22, _e7155.member_23, _e7155.member_24, _e7155.member_25, _e7155.member_26, _e7155.member_27);
} else {
phi_5958_ = _e7155;
}
let _e7185 = phi_5958_;
phi_5959_ = _e7185;
}
let _e7215 = phi_5959_;
phi_9416_ = _e7215;
phi_9417_ = type_25();
phi_9418_ = true;
} else {
let _e2116 = local_2;
let _e2118 = local_3;
let _e2120 = (!(_e1504) && (_e2116 == _e2118));
if _e2120 {
let _e5554 = type_25(_e2109.member, _e2109.member_1, _e2109.member_2, _e2109.member_3, _e2109.member_4, _e2109.member_5, _e2109.member_6, _e1513, _e2109.member_8, _e2109.member_9, _e2109.member_10, _e2109.member_11, _e2109.member_12, _e2109.member_13, _e2109.member_14, _e2109.member_15, _e2109.member_16, _e2109.member_17, _e2109.member_18, _e2109.member_19, _e2109.member_20, _e2109.member_21, _e2109.member_22, _e2109.member_23, _e2109.member_24, _e2109.member_25, _e2109.member_26, _e2109.member_27);
let _e5585 = type_25(_e5554.member, _e5554.member_1, _e5554.member_2, _e5554.member_3, _e5554.member_4, _e5554.member_5, _e5554.member_6, _e5554.member_7, _e5554.member_8, _e5554.member_9, _e5554.member_10, _e5554.member_11, _e5554.member_12, select(1.1754944e-38f, _e2109.member_14, (_e2109.member_14 > 1.1754944e-38f)), _e5554.member_14, _e5554.member_15, _e5554.member_16, _e5554.member_17, _e5554.member_18, _e5554.member_19, _e5554.member_20, _e5554.member_21, _e5554.member_22, _e5554.member_23, _e5554.member_24, _e5554.member_25, _e5554.member_26, _e5554.member_27);
let _e5613 = type_25(_e5585.member, _e5585.member_1, _e5585.member_2, _e5585.member_3, _e5585.member_4, _e5585.member_5, _e5585.member_6, _e5585.member_7, _e5585.member_8, _e5585.member_9, _e5585.member_10, 0i, _e5585.member_12, _e5585.member_13, _e5585.member_14, _e5585.member_15, _e5585.member_16, _e5585.member_17, _e5585.member_18, _e5585.member_19, _e5585.member_20, _e5585.member_21, _e5585.member_22, _e5585.member_23, _e5585.member_24, _e5585.member_25, _e5585.member_26, _e5585.member_27);
let _e5641 = type_25(_e5613.member, _e5613.member_1, _e5613.member_2, _e5613.member_3, _e5613.member_4, _e5613.member_5, _e5613.member_6, _e5613.member_7, _e5613.member_8, _e5613.member_9, _e5613.member_10, _e5613.member_11, 0i, _e5613.member_13, _e5613.member_14, _e5613.member_15, _e5613.member_16, _e5613.member_17, _e5613.member_18, _e5613.member_19, _e5613.member_20, _e5613.member_21, _e5613.member_22, _e5613.member_23, _e5613.member_24, _e5613.member_25, _e5613.member_26, _e5613.member_27);
let _e5648 = global_5.member.member_14.member.member;
let _e5662 = ((((_e5648.member.member * _e2109.member.x) + (_e5648.member.member_1 * _e2109.member.y)) + (_e5648.member.member_2 * _e2109.member.z)) + _e5648.member_1);
let _e5671 = -((((_e5648.member.member * _e2109.member_1.x) + (_e5648.member.member_1 * _e2109.member_1.y)) + (_e5648.member.member_2 * _e2109.member_1.z)));
let _e5673 = (_e5671 > 1e-9f);
let _e5677 = ((_e5662 / select(1e-9f, _e5671, _e5673)) - 0.015625f);
let _e5680 = select(1e30f, select(0f, _e5677, (_e5677 > 0f)), ((_e5662 > 0f) && _e5673));
let _e5685 = global_5.member.member_14.member_1.member;
let _e5696 = ((((_e5685.member.member * _e2109.member.x) + (_e5685.member.member_1 * _e2109.member.y)) + (_e5685.member.member_2 * _e2109.member.z)) + _e5685.member_1);
let _e5702 = -((((_e5685.member.member * _e2109.member_1.x) + (_e5685.member.member_1 * _e2109.member_1.y)) + (_e5685.member.member_2 * _e2109.member_1.z)));
let _e5704 = (_e5702 > 1e-9f);
let _e5708 = ((_e5696 / select(1e-9f, _e5702, _e5704)) - 0.015625f);
let _e5711 = select(1e30f, select(0f, _e5708, (_e5708 > 0f)), ((_e5696 > 0f) && _e5704));
let _e5715 = (_e5711 < _e5680);
let _e5746 = type_25(_e5641.member, _e5641.member_1, _e5641.member_2, _e5641.member_3, _e5641.member_4, _e5641.member_5, _e5641.member_6, _e5641.member_7, 0i, _e5641.member_9, _e5641.member_10, _e5641.member_11, _e5641.member_12, _e5641.member_13, _e5641.member_14, _e5641.member_15, _e5641.member_16, _e5641.member_17, _e5641.member_18, _e5641.member_19, _e5641.member_20, _e5641.member_21, _e5641.member_22, _e5641.member_23, _e5641.member_24, _e5641.member_25, _e5641.member_26, _e5641.member_27);
let _e5774 = type_25(_e5746.member, _e5746.member_1, _e5746.member_2, _e5746.member_3, _e5746.member_4, _e5746.member_5, _e5746.member_6, _e5746.member_7, _e5746.member_8, select(select(-2i, -3i, _e5715), -1i, ((_e5680 >= 1e30f) && (_e5711 >= 1e30f))), _e5746.member_10, _e5746.member_11, _e5746.member_12, _e5746.member_13, _e5746.member_14, _e5746.member_15, _e5746.member_16, _e5746.member_17, _e5746.member_18, _e5746.member_19, _e5746.member_20, _e5746.member_21, _e5746.member_22, _e5746.member_23, _e5746.member_24, _e5746.member_25, _e5746.member_26, _e5746.member_27);
phi_9414_ = type_25(_e5774.member, _e5774.member_1, _e5774.member_2, _e5774.member_3, _e5774.member_4, _e5774.member_5, _e5774.member_6, _e5774.member_7, _e5774.member_8, _e5774.member_9, select(_e5680, _e5711, _e5715), _e5774.member_11, _e5774.member_12, _e5774.member_13, _e5774.member_14, _e5774.member_15, _e5774.member_16, _e5774.member_17, _e5774.member_18, _e5774.member_19, _e5774.member_20, _e5774.member_21, _e5774.member_22, _e5774.member_23, _e5774.member_24, _e5774.member_25, _e5774.member_26, _e5774.member_27);
phi_9415_ = type_25();
} else {
let _e2131 = (_e2109.member.x + (_e2109.member_1.x * _e2109.member_10));
let _e2134 = (_e2109.member.y + (_e2109.member_1.y * _e2109.member_10));
let _e2137 = (_e2109.member.z + (_e2109.member_1.z * _e2109.member_10));
let _e2166 = type_25(vec3<f32>(_e2131, _e2134, _e2137), _e2109.member_1, _e2109.member_2, _e2109.member_3, _e2109.member_4, _e2109.member_5, _e2109.member_6, _e2109.member_7, _e2109.member_8, _e2109.member_9, _e2109.member_10, _e2109.member_11, _e2109.member_12, _e2109.member_13, _e2109.member_14, _e2109.member_15, _e2109.member_16, _e2109.member_17, _e2109.member_18, _e2109.member_19, _e2109.member_20, _e2109.member_21, _e2109.member_22, _e2109.member_23, _e2109.member_24, _e2109.member_25, _e2109.member_26, _e2109.member_27);
let _e2168 = (_e2109.member_9 * 19i);
let _e2170 = select(_e1474, _e2168, (_e2168 < _e1474));
let _e2176 = global_2.member[bitcast<u32>(select(0i, _e2170, (_e2170 > 0i)))];
let _e2177 = (_e2168 + 1i);
let _e2179 = select(_e1474, _e2177, (_e2177 < _e1474));
let _e2185 = global_2.member[bitcast<u32>(select(0i, _e2179, (_e2179 > 0i)))];
let _e2186 = (_e2168 + 2i);
let _e2188 = select(_e1474, _e2186, (_e2186 < _e1474));
let _e2194 = global_2.member[bitcast<u32>(select(0i, _e2188, (_e2188 > 0i)))];
let _e2195 = (_e2168 + 3i);
let _e2197 = select(_e1474, _e2195, (_e2195 < _e1474));
let _e2203 = global_2.member[bitcast<u32>(select(0i, _e2197, (_e2197 > 0i)))];
let _e2204 = (_e2168 + 4i);
let _e2206 = select(_e1474, _e2204, (_e2204 < _e1474));
let _e2212 = global_2.member[bitcast<u32>(select(0i, _e2206, (_e2206 > 0i)))];
let _e2213 = (_e2168 + 5i);
let _e2215 = select(_e1474, _e2213, (_e2213 < _e1474));
let _e2221 = global_2.member[bitcast<u32>(select(0i, _e2215, (_e2215 > 0i)))];
let _e2222 = (_e2203 - _e2176);
let _e2223 = (_e2212 - _e2185);
let _e2224 = (_e2221 - _e2194);
let _e2225 = (_e2168 + 6i);
let _e2227 = select(_e1474, _e2225, (_e2225 < _e1474));
let _e2233 = global_2.member[bitcast<u32>(select(0i, _e2227, (_e2227 > 0i)))];
let _e2234 = (_e2168 + 7i);
let _e2236 = select(_e1474, _e2234, (_e2234 < _e1474));
let _e2242 = global_2.member[bitcast<u32>(select(0i, _e2236, (_e2236 > 0i)))];
let _e2243 = (_e2168 + 8i);
let _e2245 = select(_e1474, _e2243, (_e2243 < _e1474));
let _e2251 = global_2.member[bitcast<u32>(select(0i, _e2245, (_e2245 > 0i)))];
let _e2252 = (_e2233 - _e2176);
let _e2253 = (_e2242 - _e2185);
let _e2254 = (_e2251 - _e2194);
let _e2257 = ((_e2223 * _e2254) - (_e2224 * _e2253));
let _e2260 = ((_e2224 * _e2252) - (_e2222 * _e2254));
let _e2263 = ((_e2222 * _e2253) - (_e2223 * _e2252));
let _e2268 = (((_e2257 * _e2257) + (_e2260 * _e2260)) + (_e2263 * _e2263));
let _e2280 = (1f / select(1e-30f, _e2268, (_e2268 > 1e-30f)));
let _e2281 = (((_e2253 * _e2263) - (_e2254 * _e2260)) * _e2280);
let _e2282 = (((_e2254 * _e2257) - (_e2252 * _e2263)) * _e2280);
let _e2283 = (((_e2252 * _e2260) - (_e2253 * _e2257)) * _e2280);
let _e2293 = (((_e2260 * _e2224) - (_e2263 * _e2223)) * _e2280);
let _e2294 = (((_e2263 * _e2222) - (_e2257 * _e2224)) * _e2280);
let _e2295 = (((_e2257 * _e2223) - (_e2260 * _e2222)) * _e2280);
let _e2296 = (_e2168 + 9i);
let _e2298 = select(_e1474, _e2296, (_e2296 < _e1474));
let _e2304 = global_2.member[bitcast<u32>(select(0i, _e2298, (_e2298 > 0i)))];
let _e2305 = (_e2168 + 10i);
let _e2307 = select(_e1474, _e2305, (_e2305 < _e1474));
let _e2313 = global_2.member[bitcast<u32>(select(0i, _e2307, (_e2307 > 0i)))];
let _e2314 = (_e2168 + 11i);
let _e2316 = select(_e1474, _e2314, (_e2314 < _e1474));
let _e2322 = global_2.member[bitcast<u32>(select(0i, _e2316, (_e2316 > 0i)))];
let _e2323 = (_e2168 + 12i);
let _e2325 = select(_e1474, _e2323, (_e2323 < _e1474));
let _e2331 = global_2.member[bitcast<u32>(select(0i, _e2325, (_e2325 > 0i)))];
let _e2332 = (_e2168 + 13i);
let _e2334 = select(_e1474, _e2332, (_e2332 < _e1474));
let _e2340 = global_2.member[bitcast<u32>(select(0i, _e2334, (_e2334 > 0i)))];
let _e2341 = (_e2168 + 14i);
let _e2343 = select(_e1474, _e2341, (_e2341 < _e1474));
let _e2349 = global_2.member[bitcast<u32>(select(0i, _e2343, (_e2343 > 0i)))];
let _e2350 = (_e2331 - _e2304);
let _e2351 = (_e2340 - _e2313);
let _e2352 = (_e2349 - _e2322);
let _e2353 = (_e2168 + 15i);
let _e2355 = select(_e1474, _e2353, (_e2353 < _e1474));
let _e2361 = global_2.member[bitcast<u32>(select(0i, _e2355, (_e2355 > 0i)))];
let _e2362 = (_e2168 + 16i);
let _e2364 = select(_e1474, _e2362, (_e2362 < _e1474));
let _e2370 = global_2.member[bitcast<u32>(select(0i, _e2364, (_e2364 > 0i)))];
let _e2371 = (_e2168 + 17i);
let _e2373 = select(_e1474, _e2371, (_e2371 < _e1474));
let _e2379 = global_2.member[bitcast<u32>(select(0i, _e2373, (_e2373 > 0i)))];
let _e2380 = (_e2361 - _e2304);
let _e2381 = (_e2370 - _e2313);
let _e2382 = (_e2379 - _e2322);
let _e2383 = (_e2131 - _e2176);
let _e2384 = (_e2134 - _e2185);
let _e2385 = (_e2137 - _e2194);
let _e2390 = (((_e2281 * _e2383) + (_e2282 * _e2384)) + (_e2283 * _e2385));
let _e2401 = (((_e2293 * _e2383) + (_e2294 * _e2384)) + (_e2295 * _e2385));
let _e2405 = ((_e2304 + (_e2350 * _e2390)) + (_e2380 * _e2401));
let _e2406 = ((_e2313 + (_e2351 * _e2390)) + (_e2381 * _e2401));
let _e2407 = ((_e2322 + (_e2352 * _e2390)) + (_e2382 * _e2401));
let _e2412 = (((_e2405 * _e2405) + (_e2406 * _e2406)) + (_e2407 * _e2407));
let _e2415 = sqrt(select(0f, _e2412, (_e2412 > 0f)));
let _e2418 = (1f / select(1e-20f, _e2415, (_e2415 > 1e-20f)));
let _e2421 = sqrt(select(0f, _e2268, (_e2268 > 0f)));
let _e2424 = (1f / select(1e-20f, _e2421, (_e2421 > 1e-20f)));
let _e2425 = (_e2257 * _e2424);
let _e2426 = (_e2260 * _e2424);
let _e2427 = (_e2263 * _e2424);
let _e2428 = (_e2405 * _e2418);
let _e2429 = (_e2406 * _e2418);
let _e2430 = (_e2407 * _e2418);
if _e1504 {
phi_6581_ = 1f;
phi_6582_ = 1f;
} else {
let _e2432 = local_4;
let _e2433 = (_e2432 * 4i);
let _e2435 = select(_e1492, _e2433, (_e2433 < _e1492));
let _e2441 = global_3.member[bitcast<u32>(select(0i, _e2435, (_e2435 > 0i)))];
let _e2444 = local_5;
let _e2445 = (_e2444 * 4i);
let _e2447 = select(_e1492, _e2445, (_e2445 < _e1492));
let _e2453 = global_3.member[bitcast<u32>(select(0i, _e2447, (_e2447 > 0i)))];
let _e2455 = local_6;
phi_6581_ = select(_e2453, 1f, (_e2455 == 16i));
phi_6582_ = select(_e2441, 1f, _e1447);
}
let _e2459 = phi_6581_;
let _e2461 = phi_6582_;
let _e2468 = select(1f, -1f, ((((_e2109.member_1.x * _e2428) + (_e2109.member_1.y * _e2429)) + (_e2109.member_1.z * _e2430)) > 0f));
let _e2469 = (_e2428 * _e2468);
let _e2470 = (_e2429 * _e2468);
let _e2471 = (_e2430 * _e2468);
let _e2477 = -((((_e2109.member_1.x * _e2469) + (_e2109.member_1.y * _e2470)) + (_e2109.member_1.z * _e2471)));
let _e2479 = select(0f, _e2477, (_e2477 > 0f));
let _e2480 = (_e2461 / _e2459);
let _e2485 = (1f - ((_e2480 * _e2480) * (1f - (_e2479 * _e2479))));
let _e2486 = (_e2485 <= 0f);
let _e2494 = ((_e2480 * _e2479) - sqrt(select(0f, _e2485, (_e2485 > 0f))));
let _e2501 = (2f * _e2479);
let _e2505 = (_e2109.member_1.x + (_e2469 * _e2501));
let _e2506 = (_e2109.member_1.y + (_e2470 * _e2501));
let _e2507 = (_e2109.member_1.z + (_e2471 * _e2501));
let _e2508 = select(((_e2109.member_1.x * _e2480) + (_e2469 * _e2494)), _e2505, _e2486);
let _e2509 = select(((_e2109.member_1.y * _e2480) + (_e2470 * _e2494)), _e2506, _e2486);
let _e2510 = select(((_e2109.member_1.z * _e2480) + (_e2471 * _e2494)), _e2507, _e2486);
let _e2515 = (((_e2508 * _e2508) + (_e2509 * _e2509)) + (_e2510 * _e2510));
let _e2518 = sqrt(select(0f, _e2515, (_e2515 > 0f)));
let _e2521 = (1f / select(1e-20f, _e2518, (_e2518 > 1e-20f)));
let _e2529 = (((_e2109.member_1.x * _e2425) + (_e2109.member_1.y * _e2426)) + (_e2109.member_1.z * _e2427));
let _e2556 = !((((((((_e2428 * _e2109.member_1.x) + (_e2429 * _e2109.member_1.y)) + (_e2430 * _e2109.member_1.z)) * _e2529) > 0f) && (((((((_e2508 * _e2521) * _e2425) + ((_e2509 * _e2521) * _e2426)) + ((_e2510 * _e2521) * _e2427)) * select(1f, -1f, _e2486)) * _e2529) > 0f)) && ((-((((_e2505 * _e2425) + (_e2506 * _e2426)) + (_e2507 * _e2427))) * _e2529) > 0f)));
let _e2557 = select(_e2428, _e2425, _e2556);
let _e2558 = select(_e2429, _e2426, _e2556);
let _e2559 = select(_e2430, _e2427, _e2556);
let _e2560 = select(_e2281, 0f, _e2556);
let _e2561 = select(_e2282, 0f, _e2556);
let _e2562 = select(_e2283, 0f, _e2556);
let _e2563 = select(_e2293, 0f, _e2556);
let _e2564 = select(_e2294, 0f, _e2556);
let _e2565 = select(_e2295, 0f, _e2556);
let _e2577 = (_e2109.member_2.x + (_e2109.member_4.x * _e2109.member_10));
let _e2579 = (_e2109.member_2.y + (_e2109.member_4.y * _e2109.member_10));
let _e2581 = (_e2109.member_2.z + (_e2109.member_4.z * _e2109.member_10));
let _e2589 = (_e2109.member_3.x + (_e2109.member_5.x * _e2109.member_10));
let _e2591 = (_e2109.member_3.y + (_e2109.member_5.y * _e2109.member_10));
let _e2593 = (_e2109.member_3.z + (_e2109.member_5.z * _e2109.member_10));
if ((_e2529 * _e2529) > 1e-12f) {
phi_6815_ = (1f / _e2529);
} else {
phi_6815_ = 0f;
}
let _e2598 = phi_6815_;
let _e2604 = ((((_e2577 * _e2425) + (_e2579 * _e2426)) + (_e2581 * _e2427)) * _e2598);
let _e2608 = (_e2577 - (_e2109.member_1.x * _e2604));
let _e2609 = (_e2579 - (_e2109.member_1.y * _e2604));
let _e2610 = (_e2581 - (_e2109.member_1.z * _e2604));
let _e2611 = vec3<f32>(_e2608, _e2609, _e2610);
let _e2617 = ((((_e2589 * _e2425) + (_e2591 * _e2426)) + (_e2593 * _e2427)) * _e2598);
let _e2621 = (_e2589 - (_e2109.member_1.x * _e2617));
let _e2622 = (_e2591 - (_e2109.member_1.y * _e2617));
let _e2623 = (_e2593 - (_e2109.member_1.z * _e2617));
let _e2624 = vec3<f32>(_e2621, _e2622, _e2623);
let _e2652 = type_25(_e2166.member, _e2166.member_1, _e2611, _e2166.member_3, _e2166.member_4, _e2166.member_5, _e2166.member_6, _e2166.member_7, _e2166.member_8, _e2166.member_9, _e2166.member_10, _e2166.member_11, _e2166.member_12, _e2166.member_13, _e2166.member_14, _e2166.member_15, _e2166.member_16, _e2166.member_17, _e2166.member_18, _e2166.member_19, _e2166.member_20, _e2166.member_21, _e2166.member_22, _e2166.member_23, _e2166.member_24, _e2166.member_25, _e2166.member_26, _e2166.member_27);
let _e2680 = type_25(_e2652.member, _e2652.member_1, _e2652.member_2, _e2624, _e2652.member_4, _e2652.member_5, _e2652.member_6, _e2652.member_7, _e2652.member_8, _e2652.member_9, _e2652.member_10, _e2652.member_11, _e2652.member_12, _e2652.member_13, _e2652.member_14, _e2652.member_15, _e2652.member_16, _e2652.member_17, _e2652.member_18, _e2652.member_19, _e2652.member_20, _e2652.member_21, _e2652.member_22, _e2652.member_23, _e2652.member_24, _e2652.member_25, _e2652.member_26, _e2652.member_27);
let _e2708 = type_25(_e2680.member, _e2680.member_1, _e2680.member_2, _e2680.member_3, _e2109.member_4, _e2680.member_5, _e2680.member_6, _e2680.member_7, _e2680.member_8, _e2680.member_9, _e2680.member_10, _e2680.member_11, _e2680.member_12, _e2680.member_13, _e2680.member_14, _e2680.member_15, _e2680.member_16, _e2680.member_17, _e2680.member_18, _e2680.member_19, _e2680.member_20, _e2680.member_21, _e2680.member_22, _e2680.member_23, _e2680.member_24, _e2680.member_25, _e2680.member_26, _e2680.member_27);
let _e2736 = type_25(_e2708.member, _e2708.member_1, _e2708.member_2, _e2708.member_3, _e2708.member_4, _e2109.member_5, _e2708.member_6, _e2708.member_7, _e2708.member_8, _e2708.member_9, _e2708.member_10, _e2708.member_11, _e2708.member_12, _e2708.member_13, _e2708.member_14, _e2708.member_15, _e2708.member_16, _e2708.member_17, _e2708.member_18, _e2708.member_19, _e2708.member_20, _e2708.member_21, _e2708.member_22, _e2708.member_23, _e2708.member_24, _e2708.member_25, _e2708.member_26, _e2708.member_27);
if _e1504 {
let _e3470 = (_e1490 + 1i);
let _e3472 = select(_e1492, _e3470, (_e3470 < _e1492));
let _e3478 = global_3.member[bitcast<u32>(select(0i, _e3472, (_e3472 > 0i)))];
let _e3479 = (_e1490 + 2i);
let _e3481 = select(_e1492, _e3479, (_e3479 < _e1492));
let _e3487 = global_3.member[bitcast<u32>(select(0i, _e3481, (_e3481 > 0i)))];
let _e3488 = (_e1490 + 3i);
let _e3490 = select(_e1492, _e3488, (_e3488 < _e1492));
let _e3496 = global_3.member[bitcast<u32>(select(0i, _e3490, (_e3490 > 0i)))];
let _e3503 = (1f / 3f);
let _e3507 = (_e2109.member_6.x * _e3478);
let _e3510 = (_e2109.member_6.y * _e3487);
let _e3513 = (_e2109.member_6.z * _e3496);
let _e3542 = type_25(_e2736.member, _e2736.member_1, _e2736.member_2, _e2736.member_3, _e2736.member_4, _e2736.member_5, vec3<f32>(_e3507, _e3510, _e3513), _e2736.member_7, _e2736.member_8, _e2736.member_9, _e2736.member_10, _e2736.member_11, _e2736.member_12, _e2736.member_13, _e2736.member_14, _e2736.member_15, _e2736.member_16, _e2736.member_17, _e2736.member_18, _e2736.member_19, _e2736.member_20, _e2736.member_21, _e2736.member_22, _e2736.member_23, _e2736.member_24, _e2736.member_25, _e2736.member_26, _e2736.member_27);
if (bitcast<i32>(countOneBits(bitcast<u32>((_e2109.member_17 & ((1i << bitcast<u32>((_e2109.member_16 & 31i))) - 1i))))) == _e2109.member_20) {
phi_6946_ = ((((_e2109.member_6.x + _e2109.member_6.y) + _e2109.member_6.z) * _e3503) - (((_e3507 + _e3510) + _e3513) * _e3503));
} else {
phi_6946_ = 0f;
}
let _e3560 = phi_6946_;
let _e3590 = type_25(_e3542.member, _e3542.member_1, _e3542.member_2, _e3542.member_3, _e3542.member_4, _e3542.member_5, _e3542.member_6, _e3542.member_7, _e3542.member_8, _e3542.member_9, _e3542.member_10, _e3542.member_11, _e3542.member_12, _e3542.member_13, _e3542.member_14, _e3542.member_15, _e3542.member_16, _e3542.member_17, _e3542.member_18, _e3542.member_19, _e3542.member_20, _e3542.member_21, _e3542.member_22, _e3542.member_23, _e3542.member_24, (_e2109.member_25 + _e3560), _e3542.member_26, _e3542.member_27);
let _e3597 = select(1f, -1f, ((((_e2557 * _e2109.member_1.x) + (_e2558 * _e2109.member_1.y)) + (_e2559 * _e2109.member_1.z)) > 0f));
let _e3598 = (_e2557 * _e3597);
let _e3599 = (_e2558 * _e3597);
let _e3600 = (_e2559 * _e3597);
let _e3601 = (_e2350 * _e3597);
let _e3602 = (_e2351 * _e3597);
let _e3603 = (_e2352 * _e3597);
let _e3604 = (_e2380 * _e3597);
let _e3605 = (_e2381 * _e3597);
let _e3606 = (_e2382 * _e3597);
let _e3611 = (((_e2560 * _e2608) + (_e2561 * _e2609)) + (_e2562 * _e2610));
let _e3619 = (((_e2563 * _e2608) + (_e2564 * _e2609)) + (_e2565 * _e2610));
let _e3626 = (((_e3601 * _e3611) + (_e3604 * _e3619)) * _e2418);
let _e3627 = (((_e3602 * _e3611) + (_e3605 * _e3619)) * _e2418);
let _e3628 = (((_e3603 * _e3611) + (_e3606 * _e3619)) * _e2418);
let _e3633 = (((_e3598 * _e3626) + (_e3599 * _e3627)) + (_e3600 * _e3628));
let _e3637 = (_e3626 - (_e3598 * _e3633));
let _e3638 = (_e3627 - (_e3599 * _e3633));
let _e3639 = (_e3628 - (_e3600 * _e3633));
let _e3644 = (((_e2109.member_1.x * _e3598) + (_e2109.member_1.y * _e3599)) + (_e2109.member_1.z * _e3600));
let _e3645 = -(_e3644);
let _e3657 = -(((((_e2109.member_4.x * _e3598) + (_e2109.member_4.y * _e3599)) + (_e2109.member_4.z * _e3600)) + (((_e2109.member_1.x * _e3637) + (_e2109.member_1.y * _e3638)) + (_e2109.member_1.z * _e3639))));
let _e3676 = (((_e2560 * _e2621) + (_e2561 * _e2622)) + (_e2562 * _e2623));
let _e3684 = (((_e2563 * _e2621) + (_e2564 * _e2622)) + (_e2565 * _e2623));
let _e3691 = (((_e3601 * _e3676) + (_e3604 * _e3684)) * _e2418);
let _e3692 = (((_e3602 * _e3676) + (_e3605 * _e3684)) * _e2418);
let _e3693 = (((_e3603 * _e3676) + (_e3606 * _e3684)) * _e2418);
let _e3698 = (((_e3598 * _e3691) + (_e3599 * _e3692)) + (_e3600 * _e3693));
let _e3702 = (_e3691 - (_e3598 * _e3698));
let _e3703 = (_e3692 - (_e3599 * _e3698));
let _e3704 = (_e3693 - (_e3600 * _e3698));
let _e3716 = -(((((_e2109.member_5.x * _e3598) + (_e2109.member_5.y * _e3599)) + (_e2109.member_5.z * _e3600)) + (((_e2109.member_1.x * _e3702) + (_e2109.member_1.y * _e3703)) + (_e2109.member_1.z * _e3704))));
let _e3758 = type_25(_e3590.member, _e3590.member_1, _e2611, _e3590.member_3, _e3590.member_4, _e3590.member_5, _e3590.member_6, _e3590.member_7, _e3590.member_8, _e3590.member_9, _e3590.member_10, _e3590.member_11, _e3590.member_12, _e3590.member_13, _e3590.member_14, _e3590.member_15, _e3590.member_16, _e3590.member_17, _e3590.member_18, _e3590.member_19, _e3590.member_20, _e3590.member_21, _e3590.member_22, _e3590.member_23, _e3590.member_24, _e3590.member_25, _e3590.member_26, _e3590.member_27);
let _e3786 = type_25(_e3758.member, _e3758.member_1, _e3758.member_2, _e2624, _e3758.member_4, _e3758.member_5, _e3758.member_6, _e3758.member_7, _e3758.member_8, _e3758.member_9, _e3758.member_10, _e3758.member_11, _e3758.member_12, _e3758.member_13, _e3758.member_14, _e3758.member_15, _e3758.member_16, _e3758.member_17, _e3758.member_18, _e3758.member_19, _e3758.member_20, _e3758.member_21, _e3758.member_22, _e3758.member_23, _e3758.member_24, _e3758.member_25, _e3758.member_26, _e3758.member_27);
let _e3814 = type_25(_e3786.member, _e3786.member_1, _e3786.member_2, _e3786.member_3, (_e2109.member_4 + vec3<f32>((((_e3637 * _e3645) + (_e3598 * _e3657)) * 2f), (((_e3638 * _e3645) + (_e3599 * _e3657)) * 2f), (((_e3639 * _e3645) + (_e3600 * _e3657)) * 2f))), _e3786.member_5, _e3786.member_6, _e3786.member_7, _e3786.member_8, _e3786.member_9, _e3786.member_10, _e3786.member_11, _e3786.member_12, _e3786.member_13, _e3786.member_14, _e3786.member_15, _e3786.member_16, _e3786.member_17, _e3786.member_18, _e3786.member_19, _e3786.member_20, _e3786.member_21, _e3786.member_22, _e3786.member_23, _e3786.member_24, _e3786.member_25, _e3786.member_26, _e3786.member_27);
let _e3842 = type_25(_e3814.member, _e3814.member_1, _e3814.member_2, _e3814.member_3, _e3814.member_4, (_e2109.member_5 + vec3<f32>((((_e3702 * _e3645) + (_e3598 * _e3716)) * 2f), (((_e3703 * _e3645) + (_e3599 * _e3716)) * 2f), (((_e3704 * _e3645) + (_e3600 * _e3716)) * 2f))), _e3814.member_6, _e3814.member_7, _e3814.member_8, _e3814.member_9, _e3814.member_10, _e3814.member_11, _e3814.member_12, _e3814.member_13, _e3814.member_14, _e3814.member_15, _e3814.member_16, _e3814.member_17, _e3814.member_18, _e3814.member_19, _e3814.member_20, _e3814.member_21, _e3814.member_22, _e3814.member_23, _e3814.member_24, _e3814.member_25, _e3814.member_26, _e3814.member_27);
let _e3844 = select(1f, -1f, (_e3644 > 0f));
let _e3845 = (_e3598 * _e3844);
let _e3846 = (_e3599 * _e3844);
let _e3847 = (_e3600 * _e3844);
let _e3853 = -((((_e2109.member_1.x * _e3845) + (_e2109.member_1.y * _e3846)) + (_e2109.member_1.z * _e3847)));
let _e3856 = (2f * select(0f, _e3853, (_e3853 > 0f)));
let _e3889 = type_25(_e3842.member, (_e2109.member_1 + vec3<f32>((_e3845 * _e3856), (_e3846 * _e3856), (_e3847 * _e3856))), _e3842.member_2, _e3842.member_3, _e3842.member_4, _e3842.member_5, _e3842.member_6, _e3842.member_7, _e3842.member_8, _e3842.member_9, _e3842.member_10, _e3842.member_11, _e3842.member_12, _e3842.member_13, _e3842.member_14, _e3842.member_15, _e3842.member_16, _e3842.member_17, _e3842.member_18, _e3842.member_19, _e3842.member_20, _e3842.member_21, _e3842.member_22, _e3842.member_23, _e3842.member_24, _e3842.member_25, _e3842.member_26, _e3842.member_27);
phi_7950_ = type_25(_e3889.member, _e3889.member_1, _e3889.member_2, _e3889.member_3, _e3889.member_4, _e3889.member_5, _e3889.member_6, _e3889.member_7, _e3889.member_8, _e3889.member_9, _e3889.member_10, _e3889.member_11, _e3889.member_12, _e3889.member_13, _e3889.member_14, _e3889.member_15, (_e2109.member_16 + 1i), _e3889.member_17, _e3889.member_18, _e3889.member_19, _e3889.member_20, _e3889.member_21, _e3889.member_22, _e3889.member_23, _e3889.member_24, _e3889.member_25, _e3889.member_26, _e3889.member_27);
} else {
let _e2740 = global_5.member.member_12.member_2;
let _e2742 = local_7;
let _e2743 = (_e2742 * 4i);
let _e2745 = select(_e1492, _e2743, (_e2743 < _e1492));
let _e2751 = global_3.member[bitcast<u32>(select(0i, _e2745, (_e2745 > 0i)))];
let _e2752 = select(_e2751, 1f, _e1447);
let _e2754 = local_8;
let _e2755 = (_e2754 * 4i);
let _e2757 = select(_e1492, _e2755, (_e2755 < _e1492));
let _e2763 = global_3.member[bitcast<u32>(select(0i, _e2757, (_e2757 > 0i)))];
let _e2765 = local_9;
let _e2767 = select(_e2763, 1f, (_e2765 == 16i));
let _e2774 = select(1f, -1f, ((((_e2109.member_1.x * _e2557) + (_e2109.member_1.y * _e2558)) + (_e2109.member_1.z * _e2559)) > 0f));
let _e2775 = (_e2557 * _e2774);
let _e2776 = (_e2558 * _e2774);
let _e2777 = (_e2559 * _e2774);
let _e2783 = -((((_e2109.member_1.x * _e2775) + (_e2109.member_1.y * _e2776)) + (_e2109.member_1.z * _e2777)));
let _e2785 = select(0f, _e2783, (_e2783 > 0f));
let _e2786 = (_e2752 / _e2767);
let _e2787 = (_e2786 * _e2786);
let _e2788 = (_e2785 * _e2785);
let _e2791 = (1f - (_e2787 * (1f - _e2788)));
let _e2792 = (_e2791 <= 0f);
let _e2800 = ((_e2786 * _e2785) - sqrt(select(0f, _e2791, (_e2791 > 0f))));
let _e2807 = (2f * _e2785);
let _e2808 = (_e2775 * _e2807);
let _e2809 = (_e2776 * _e2807);
let _e2810 = (_e2777 * _e2807);
let _e2816 = select(((_e2109.member_1.x * _e2786) + (_e2775 * _e2800)), (_e2109.member_1.x + _e2808), _e2792);
let _e2817 = select(((_e2109.member_1.y * _e2786) + (_e2776 * _e2800)), (_e2109.member_1.y + _e2809), _e2792);
let _e2818 = select(((_e2109.member_1.z * _e2786) + (_e2777 * _e2800)), (_e2109.member_1.z + _e2810), _e2792);
let _e2823 = (((_e2816 * _e2816) + (_e2817 * _e2817)) + (_e2818 * _e2818));
let _e2826 = sqrt(select(0f, _e2823, (_e2823 > 0f)));
let _e2829 = (1f / select(1e-20f, _e2826, (_e2826 > 1e-20f)));
let _e2834 = (_e2767 / _e2752);
let _e2837 = (((_e2834 * _e2834) - 1f) + _e2788);
let _e2840 = sqrt(select(0f, _e2837, (_e2837 > 0f)));
let _e2841 = (_e2840 - _e2785);
let _e2842 = (_e2840 + _e2785);
let _e2845 = (_e2841 / select(1e-6f, _e2842, (_e2842 > 1e-6f)));
let _e2849 = ((_e2785 * _e2841) + 1f);
let _e2852 = (((_e2785 * _e2842) - 1f) / select(1e-6f, _e2849, (_e2849 > 1e-6f)));
let _e2861 = select(select((((0.5f * _e2845) * _e2845) * (1f + (_e2852 * _e2852))), 1f, (_e2837 <= 0f)), 0f, (_e2752 == _e2767));
let _e2864 = (1f - _e2861);
let _e2866 = select(_e2864, _e2861, (_e2861 < _e2864));
let _e2870 = (_e2109.member_16 & 31i);
if (!(_e2792) && (_e2109.member_16 >= _e2109.member_19)) {
let _e2883 = select(_e2109.member_6.y, _e2109.member_6.x, (_e2109.member_6.x > _e2109.member_6.y));
let _e2888 = ((select(_e2109.member_6.z, _e2883, (_e2883 > _e2109.member_6.z)) * _e2866) >= _e2740);
let _e2890 = (1i << bitcast<u32>(_e2870));
if (bitcast<i32>(countOneBits(bitcast<u32>((_e2109.member_17 & (_e2890 - 1i))))) == _e2109.member_20) {
if _e2888 {
phi_7619_ = type_25(_e2736.member, _e2736.member_1, _e2736.member_2, _e2736.member_3, _e2736.member_4, _e2736.member_5, _e2736.member_6, _e2736.member_7, _e2736.member_8, _e2736.member_9, _e2736.member_10, _e2736.member_11, _e2736.member_12, _e2736.member_13, _e2736.member_14, _e2736.member_15, _e2736.member_16, _e2736.member_17, _e2736.member_18, _e2736.member_19, _e2736.member_20, 1i, _e2736.member_22, _e2736.member_23, _e2736.member_24, _e2736.member_25, _e2736.member_26, _e2736.member_27);
} else {
phi_7619_ = type_25(_e2736.member, _e2736.member_1, _e2736.member_2, _e2736.member_3, _e2736.member_4, _e2736.member_5, _e2736.member_6, _e2736.member_7, _e2736.member_8, _e2736.member_9, _e2736.member_10, _e2736.member_11, _e2736.member_12, _e2736.member_13, _e2736.member_14, _e2736.member_15, _e2736.member_16, _e2736.member_17, _e2736.member_18, _e2736.member_19, _e2736.member_20, _e2736.member_21, _e2736.member_22, _e2736.member_23, _e2736.member_24, _e2736.member_25, _e2736.member_26, (_e2109.member_27 + ((((_e2109.member_6.x + _e2109.member_6.y) + _e2109.member_6.z) * (1f / 3f)) * _e2866)));
}
let _e2993 = phi_7619_;
phi_7629_ = _e2993;
} else {
phi_7629_ = type_25(_e2736.member, _e2736.member_1, _e2736.member_2, _e2736.member_3, _e2736.member_4, _e2736.member_5, _e2736.member_6, _e2736.member_7, _e2736.member_8, _e2736.member_9, _e2736.member_10, _e2736.member_11, _e2736.member_12, _e2736.member_13, _e2736.member_14, _e2736.member_15, _e2736.member_16, _e2736.member_17, (_e2109.member_18 | select(0i, _e2890, _e2888)), _e2736.member_19, _e2736.member_20, _e2736.member_21, _e2736.member_22, _e2736.member_23, _e2736.member_24, _e2736.member_25, _e2736.member_26, _e2736.member_27);
}
let _e2995 = phi_7629_;
phi_7630_ = _e2995;
} else {
phi_7630_ = _e2736;
}
let _e2997 = phi_7630_;
let _e2998 = (((_e2109.member_16 < _e2109.member_19) && (((_e2109.member_17 >> bitcast<u32>(_e2870)) & 1i) == 1i)) != (_e2861 > 0.5f));
let _e2999 = (_e2792 || _e2998);
if _e2792 {
phi_7650_ = _e2997;
} else {
let _e3000 = select(_e2864, _e2861, _e2998);
phi_7650_ = type_25(_e2997.member, _e2997.member_1, _e2997.member_2, _e2997.member_3, _e2997.member_4, _e2997.member_5, vec3<f32>((_e2997.member_6.x * _e3000), (_e2997.member_6.y * _e3000), (_e2997.member_6.z * _e3000)), _e2997.member_7, _e2997.member_8, _e2997.member_9, _e2997.member_10, _e2997.member_11, _e2997.member_12, _e2997.member_13, _e2997.member_14, _e2997.member_15, _e2997.member_16, _e2997.member_17, _e2997.member_18, _e2997.member_19, _e2997.member_20, _e2997.member_21, _e2997.member_22, _e2997.member_23, _e2997.member_24, _e2997.member_25, _e2997.member_26, _e2997.member_27);
}
let _e3040 = phi_7650_;
let _e3051 = select(1f, -1f, ((((_e2557 * _e3040.member_1.x) + (_e2558 * _e3040.member_1.y)) + (_e2559 * _e3040.member_1.z)) > 0f));
let _e3052 = (_e2557 * _e3051);
let _e3053 = (_e2558 * _e3051);
let _e3054 = (_e2559 * _e3051);
let _e3055 = (_e2350 * _e3051);
let _e3056 = (_e2351 * _e3051);
let _e3057 = (_e2352 * _e3051);
let _e3058 = (_e2380 * _e3051);
let _e3059 = (_e2381 * _e3051);
let _e3060 = (_e2382 * _e3051);
let _e3072 = (((_e2560 * _e3040.member_2.x) + (_e2561 * _e3040.member_2.y)) + (_e2562 * _e3040.member_2.z));
let _e3080 = (((_e2563 * _e3040.member_2.x) + (_e2564 * _e3040.member_2.y)) + (_e2565 * _e3040.member_2.z));
let _e3087 = (((_e3055 * _e3072) + (_e3058 * _e3080)) * _e2418);
let _e3088 = (((_e3056 * _e3072) + (_e3059 * _e3080)) * _e2418);
let _e3089 = (((_e3057 * _e3072) + (_e3060 * _e3080)) * _e2418);
let _e3094 = (((_e3052 * _e3087) + (_e3053 * _e3088)) + (_e3054 * _e3089));
let _e3098 = (_e3087 - (_e3052 * _e3094));
let _e3099 = (_e3088 - (_e3053 * _e3094));
let _e3100 = (_e3089 - (_e3054 * _e3094));
let _e3106 = -((((_e3040.member_1.x * _e3052) + (_e3040.member_1.y * _e3053)) + (_e3040.member_1.z * _e3054)));
let _e3121 = -(((((_e3040.member_4.x * _e3052) + (_e3040.member_4.y * _e3053)) + (_e3040.member_4.z * _e3054)) + (((_e3040.member_1.x * _e3098) + (_e3040.member_1.y * _e3099)) + (_e3040.member_1.z * _e3100))));
if _e2999 {
phi_7805_ = (_e3040.member_4 + vec3<f32>((((_e3098 * _e3106) + (_e3052 * _e3121)) * 2f), (((_e3099 * _e3106) + (_e3053 * _e3121)) * 2f), (((_e3100 * _e3106) + (_e3054 * _e3121)) * 2f)));
} else {
let _e3125 = (1f - (_e2787 * (1f - (_e3106 * _e3106))));
let _e3127 = select(1e-12f, _e3125, (_e3125 > 1e-12f));
let _e3130 = sqrt(select(0f, _e3127, (_e3127 > 0f)));
let _e3132 = ((_e2786 * _e3106) - _e3130);
let _e3136 = ((_e2786 - ((_e2787 * _e3106) / _e3130)) * _e3121);
phi_7805_ = vec3<f32>((((_e3040.member_4.x * _e2786) + (_e3098 * _e3132)) + (_e3052 * _e3136)), (((_e3040.member_4.y * _e2786) + (_e3099 * _e3132)) + (_e3053 * _e3136)), (((_e3040.member_4.z * _e2786) + (_e3100 * _e3132)) + (_e3054 * _e3136)));
}
let _e3168 = phi_7805_;
let _e3176 = (((_e2560 * _e3040.member_3.x) + (_e2561 * _e3040.member_3.y)) + (_e2562 * _e3040.member_3.z));
let _e3184 = (((_e2563 * _e3040.member_3.x) + (_e2564 * _e3040.member_3.y)) + (_e2565 * _e3040.member_3.z));
let _e3191 = (((_e3055 * _e3176) + (_e3058 * _e3184)) * _e2418);
let _e3192 = (((_e3056 * _e3176) + (_e3059 * _e3184)) * _e2418);
let _e3193 = (((_e3057 * _e3176) + (_e3060 * _e3184)) * _e2418);
let _e3198 = (((_e3052 * _e3191) + (_e3053 * _e3192)) + (_e3054 * _e3193));
let _e3202 = (_e3191 - (_e3052 * _e3198));
let _e3203 = (_e3192 - (_e3053 * _e3198));
let _e3204 = (_e3193 - (_e3054 * _e3198));
let _e3219 = -(((((_e3040.member_5.x * _e3052) + (_e3040.member_5.y * _e3053)) + (_e3040.member_5.z * _e3054)) + (((_e3040.member_1.x * _e3202) + (_e3040.member_1.y * _e3203)) + (_e3040.member_1.z * _e3204))));
if _e2999 {
phi_7931_ = (_e3040.member_5 + vec3<f32>((((_e3202 * _e3106) + (_e3052 * _e3219)) * 2f), (((_e3203 * _e3106) + (_e3053 * _e3219)) * 2f), (((_e3204 * _e3106) + (_e3054 * _e3219)) * 2f)));
} else {
let _e3223 = (1f - (_e2787 * (1f - (_e3106 * _e3106))));
let _e3225 = select(1e-12f, _e3223, (_e3223 > 1e-12f));
let _e3228 = sqrt(select(0f, _e3225, (_e3225 > 0f)));
let _e3230 = ((_e2786 * _e3106) - _e3228);
let _e3234 = ((_e2786 - ((_e2787 * _e3106) / _e3228)) * _e3219);
phi_7931_ = vec3<f32>((((_e3040.member_5.x * _e2786) + (_e3202 * _e3230)) + (_e3052 * _e3234)), (((_e3040.member_5.y * _e2786) + (_e3203 * _e3230)) + (_e3053 * _e3234)), (((_e3040.member_5.z * _e2786) + (_e3204 * _e3230)) + (_e3054 * _e3234)));
}
let _e3266 = phi_7931_;
let _e3294 = type_25(_e3040.member, _e3040.member_1, _e3040.member_2, _e3040.member_3, _e3040.member_4, _e3040.member_5, _e3040.member_6, _e3040.member_7, _e3040.member_8, _e3040.member_9, _e3040.member_10, _e3040.member_11, _e3040.member_12, _e3040.member_13, _e3040.member_14, _e3040.member_15, _e3040.member_16, _e3040.member_17, _e3040.member_18, _e3040.member_19, _e3040.member_20, _e3040.member_21, _e3040.member_22, _e3040.member_23, _e3040.member_24, _e3040.member_25, _e3040.member_26, _e3040.member_27);
let _e3322 = type_25(_e3294.member, _e3294.member_1, _e3294.member_2, _e3040.member_3, _e3294.member_4, _e3294.member_5, _e3294.member_6, _e3294.member_7, _e3294.member_8, _e3294.member_9, _e3294.member_10, _e3294.member_11, _e3294.member_12, _e3294.member_13, _e3294.member_14, _e3294.member_15, _e3294.member_16, _e3294.member_17, _e3294.member_18, _e3294.member_19, _e3294.member_20, _e3294.member_21, _e3294.member_22, _e3294.member_23, _e3294.member_24, _e3294.member_25, _e3294.member_26, _e3294.member_27);
let _e3350 = type_25(_e3322.member, _e3322.member_1, _e3322.member_2, _e3322.member_3, _e3168, _e3322.member_5, _e3322.member_6, _e3322.member_7, _e3322.member_8, _e3322.member_9, _e3322.member_10, _e3322.member_11, _e3322.member_12, _e3322.member_13, _e3322.member_14, _e3322.member_15, _e3322.member_16, _e3322.member_17, _e3322.member_18, _e3322.member_19, _e3322.member_20, _e3322.member_21, _e3322.member_22, _e3322.member_23, _e3322.member_24, _e3322.member_25, _e3322.member_26, _e3322.member_27);
let _e3378 = type_25(_e3350.member, _e3350.member_1, _e3350.member_2, _e3350.member_3, _e3350.member_4, _e3266, _e3350.member_6, _e3350.member_7, _e3350.member_8, _e3350.member_9, _e3350.member_10, _e3350.member_11, _e3350.member_12, _e3350.member_13, _e3350.member_14, _e3350.member_15, _e3350.member_16, _e3350.member_17, _e3350.member_18, _e3350.member_19, _e3350.member_20, _e3350.member_21, _e3350.member_22, _e3350.member_23, _e3350.member_24, _e3350.member_25, _e3350.member_26, _e3350.member_27);
let _e3408 = type_25(_e3378.member, select(vec3<f32>((_e2816 * _e2829), (_e2817 * _e2829), (_e2818 * _e2829)), (_e2109.member_1 + vec3<f32>(_e2808, _e2809, _e2810)), vec3(_e2999)), _e3378.member_2, _e3378.member_3, _e3378.member_4, _e3378.member_5, _e3378.member_6, _e3378.member_7, _e3378.member_8, _e3378.member_9, _e3378.member_10, _e3378.member_11, _e3378.member_12, _e3378.member_13, _e3378.member_14, _e3378.member_15, _e3378.member_16, _e3378.member_17, _e3378.member_18, _e3378.member_19, _e3378.member_20, _e3378.member_21, _e3378.member_22, _e3378.member_23, _e3378.member_24, _e3378.member_25, _e3378.member_26, _e3378.member_27);
let _e3438 = type_25(_e3408.member, _e3408.member_1, _e3408.member_2, _e3408.member_3, _e3408.member_4, _e3408.member_5, _e3408.member_6, _e3408.member_7, _e3408.member_8, _e3408.member_9, _e3408.member_10, _e3408.member_11, _e3408.member_12, _e3408.member_13, _e3408.member_14, _e3408.member_15, (_e3040.member_16 + 1i), _e3408.member_17, _e3408.member_18, _e3408.member_19, _e3408.member_20, _e3408.member_21, _e3408.member_22, _e3408.member_23, _e3408.member_24, _e3408.member_25, _e3408.member_26, _e3408.member_27);
if !(_e2999) {
phi_7949_ = type_25(_e3438.member, _e3438.member_1, _e3438.member_2, _e3438.member_3, _e3438.member_4, _e3438.member_5, _e3438.member_6, _e1513, _e3438.member_8, _e3438.member_9, _e3438.member_10, _e3438.member_11, _e3438.member_12, _e3438.member_13, _e3438.member_14, _e3438.member_15, _e3438.member_16, _e3438.member_17, _e3438.member_18, _e3438.member_19, _e3438.member_20, _e3438.member_21, _e3438.member_22, _e3438.member_23, _e3438.member_24, _e3438.member_25, _e3438.member_26, _e3438.member_27);
} else {
phi_7949_ = _e3438;
}
let _e3469 = phi_7949_;
phi_7950_ = _e3469;
}
let _e3920 = phi_7950_;
let _e3948 = type_25(_e3920.member, _e3920.member_1, _e3920.member_2, _e3920.member_3, _e3920.member_4, _e3920.member_5, _e3920.member_6, _e3920.member_7, _e3920.member_8, _e3920.member_9, _e3920.member_10, _e3920.member_11, _e3920.member_12, 0f, _e3920.member_14, _e3920.member_15, _e3920.member_16, _e3920.member_17, _e3920.member_18, _e3920.member_19, _e3920.member_20, _e3920.member_21, _e3920.member_22, _e3920.member_23, _e3920.member_24, _e3920.member_25, _e3920.member_26, _e3920.member_27);
let _e3976 = type_25(_e3948.member, _e3948.member_1, _e3948.member_2, _e3948.member_3, _e3948.member_4, _e3948.member_5, _e3948.member_6, _e3948.member_7, _e3948.member_8, _e3948.member_9, _e3948.member_10, 0i, _e3948.member_12, _e3948.member_13, _e3948.member_14, _e3948.member_15, _e3948.member_16, _e3948.member_17, _e3948.member_18, _e3948.member_19, _e3948.member_20, _e3948.member_21, _e3948.member_22, _e3948.member_23, _e3948.member_24, _e3948.member_25, _e3948.member_26, _e3948.member_27);
let _e4004 = type_25(_e3976.member, _e3976.member_1, _e3976.member_2, _e3976.member_3, _e3976.member_4, _e3976.member_5, _e3976.member_6, _e3976.member_7, _e3976.member_8, _e3976.member_9, _e3976.member_10, _e3976.member_11, 0i, _e3976.member_13, _e3976.member_14, _e3976.member_15, _e3976.member_16, _e3976.member_17, _e3976.member_18, _e3976.member_19, _e3976.member_20, _e3976.member_21, _e3976.member_22, _e3976.member_23, _e3976.member_24, _e3976.member_25, _e3976.member_26, _e3976.member_27);
let _e4011 = global_5.member.member_14.member.member;
let _e4025 = ((((_e4011.member.member * _e3920.member.x) + (_e4011.member.member_1 * _e3920.member.y)) + (_e4011.member.member_2 * _e3920.member.z)) + _e4011.member_1);
let _e4034 = -((((_e4011.member.member * _e3920.member_1.x) + (_e4011.member.member_1 * _e3920.member_1.y)) + (_e4011.member.member_2 * _e3920.member_1.z)));
let _e4036 = (_e4034 > 1e-9f);
let _e4040 = ((_e4025 / select(1e-9f, _e4034, _e4036)) - 0.015625f);
let _e4043 = select(1e30f, select(0f, _e4040, (_e4040 > 0f)), ((_e4025 > 0f) && _e4036));
let _e4048 = global_5.member.member_14.member_1.member;
let _e4059 = ((((_e4048.member.member * _e3920.member.x) + (_e4048.member.member_1 * _e3920.member.y)) + (_e4048.member.member_2 * _e3920.member.z)) + _e4048.member_1);
let _e4065 = -((((_e4048.member.member * _e3920.member_1.x) + (_e4048.member.member_1 * _e3920.member_1.y)) + (_e4048.member.member_2 * _e3920.member_1.z)));
let _e4067 = (_e4065 > 1e-9f);
let _e4071 = ((_e4059 / select(1e-9f, _e4065, _e4067)) - 0.015625f);
let _e4074 = select(1e30f, select(0f, _e4071, (_e4071 > 0f)), ((_e4059 > 0f) && _e4067));
let _e4078 = (_e4074 < _e4043);
let _e4109 = type_25(_e4004.member, _e4004.member_1, _e4004.member_2, _e4004.member_3, _e4004.member_4, _e4004.member_5, _e4004.member_6, _e4004.member_7, 0i, _e4004.member_9, _e4004.member_10, _e4004.member_11, _e4004.member_12, _e4004.member_13, _e4004.member_14, _e4004.member_15, _e4004.member_16, _e4004.member_17, _e4004.member_18, _e4004.member_19, _e4004.member_20, _e4004.member_21, _e4004.member_22, _e4004.member_23, _e4004.member_24, _e4004.member_25, _e4004.member_26, _e4004.member_27);
let _e4137 = type_25(_e4109.member, _e4109.member_1, _e4109.member_2, _e4109.member_3, _e4109.member_4, _e4109.member_5, _e4109.member_6, _e4109.member_7, _e4109.member_8, select(select(-2i, -3i, _e4078), -1i, ((_e4043 >= 1e30f) && (_e4074 >= 1e30f))), _e4109.member_10, _e4109.member_11, _e4109.member_12, _e4109.member_13, _e4109.member_14, _e4109.member_15, _e4109.member_16, _e4109.member_17, _e4109.member_18, _e4109.member_19, _e4109.member_20, _e4109.member_21, _e4109.member_22, _e4109.member_23, _e4109.member_24, _e4109.member_25, _e4109.member_26, _e4109.member_27);
let _e4165 = type_25(_e4137.member, _e4137.member_1, _e4137.member_2, _e4137.member_3, _e4137.member_4, _e4137.member_5, _e4137.member_6, _e4137.member_7, _e4137.member_8, _e4137.member_9, select(_e4043, _e4074, _e4078), _e4137.member_11, _e4137.member_12, _e4137.member_13, _e4137.member_14, _e4137.member_15, _e4137.member_16, _e4137.member_17, _e4137.member_18, _e4137.member_19, _e4137.member_20, _e4137.member_21, _e4137.member_22, _e4137.member_23, _e4137.member_24, _e4137.member_25, _e4137.member_26, _e4137.member_27);
let _e4170 = global_5.member.member_12.member_3;
if (_e3920.member_16 > bitcast<i32>(_e4170)) {
if (bitcast<i32>(countOneBits(bitcast<u32>((_e3920.member_17 & ((1i << bitcast<u32>((_e3920.member_16 & 31i))) - 1i))))) == _e3920.member_20) {
phi_8105_ = (((_e3920.member_6.x + _e3920.member_6.y) + _e3920.member_6.z) * (1f / 3f));
} else {
phi_8105_ = 0f;
}
let _e4193 = phi_8105_;
let _e4223 = type_25(_e4165.member, _e4165.member_1, _e4165.member_2, _e4165.member_3, _e4165.member_4, _e4165.member_5, _e4165.member_6, _e4165.member_7, _e4165.member_8, _e4165.member_9, _e4165.member_10, _e4165.member_11, _e4165.member_12, _e4165.member_13, _e4165.member_14, _e4165.member_15, _e4165.member_16, _e4165.member_17, _e4165.member_18, _e4165.member_19, _e4165.member_20, _e4165.member_21, _e4165.member_22, _e4165.member_23, _e4165.member_24, _e4165.member_25, _e4165.member_26, (_e3920.member_27 + _e4193));
let _e4225 = (_e3920.member_18 == 0i);
if (_e4225 && (_e3920.member_21 == 0i)) {
phi_9412_ = type_25(_e4223.member, _e4223.member_1, _e4223.member_2, _e4223.member_3, _e4223.member_4, _e4223.member_5, _e4223.member_6, _e4223.member_7, _e4223.member_8, _e4223.member_9, _e4223.member_10, _e4223.member_11, _e4223.member_12, _e4223.member_13, _e4223.member_14, 3f, _e4223.member_16, _e4223.member_17, _e4223.member_18, _e4223.member_19, _e4223.member_20, _e4223.member_21, _e4223.member_22, _e4223.member_23, _e4223.member_24, _e4223.member_25, _e4223.member_26, _e4223.member_27);
} else {
if _e4225 {
let _e4355 = type_25(_e4223.member, _e4223.member_1, _e4223.member_2, _e4223.member_3, _e4223.member_4, _e4223.member_5, _e4223.member_6, _e4223.member_7, _e4223.member_8, _e4223.member_9, _e4223.member_10, _e4223.member_11, _e4223.member_12, _e4223.member_13, _e4223.member_14, _e4223.member_15, _e4223.member_16, _e4223.member_17, _e4223.member_18, _e4223.member_19, (_e3920.member_20 + 1i), _e4223.member_21, _e4223.member_22, _e4223.member_23, _e4223.member_24, _e4223.member_25, _e4223.member_26, _e4223.member_27);
let _e4383 = type_25(_e4355.member, _e4355.member_1, _e4355.member_2, _e4355.member_3, _e4355.member_4, _e4355.member_5, _e4355.member_6, _e4355.member_7, _e4355.member_8, _e4355.member_9, _e4355.member_10, _e4355.member_11, _e4355.member_12, _e4355.member_13, _e4355.member_14, _e4355.member_15, _e4355.member_16, _e4355.member_17, _e4355.member_18, _e4355.member_19, _e4355.member_20, 0i, _e4355.member_22, _e4355.member_23, _e4355.member_24, _e4355.member_25, _e4355.member_26, _e4355.member_27);
let _e4411 = type_25(_e4383.member, _e4383.member_1, _e4383.member_2, _e4383.member_3, _e4383.member_4, _e4383.member_5, _e4383.member_6, _e4383.member_7, _e4383.member_8, _e4383.member_9, _e4383.member_10, _e4383.member_11, _e4383.member_12, _e4383.member_13, _e4383.member_14, _e4383.member_15, _e4383.member_16, 0i, _e4383.member_18, _e4383.member_19, _e4383.member_20, _e4383.member_21, _e4383.member_22, _e4383.member_23, _e4383.member_24, _e4383.member_25, _e4383.member_26, _e4383.member_27);
phi_8149_ = type_25(_e4411.member, _e4411.member_1, _e4411.member_2, _e4411.member_3, _e4411.member_4, _e4411.member_5, _e4411.member_6, _e4411.member_7, _e4411.member_8, _e4411.member_9, _e4411.member_10, _e4411.member_11, _e4411.member_12, _e4411.member_13, _e4411.member_14, _e4411.member_15, _e4411.member_16, _e4411.member_17, _e4411.member_18, 0i, _e4411.member_20, _e4411.member_21, _e4411.member_22, _e4411.member_23, _e4411.member_24, _e4411.member_25, _e4411.member_26, _e4411.member_27);
} else {
let _e4233 = bitcast<i32>((bitcast<u32>(f32(_e3920.member_18)) >> bitcast<u32>(23i)));
let _e4237 = (1i << bitcast<u32>(((_e4233 - 127i) & 31i)));
let _e4238 = (_e4237 - 1i);
let _e4268 = type_25(_e4223.member, _e4223.member_1, _e4223.member_2, _e4223.member_3, _e4223.member_4, _e4223.member_5, _e4223.member_6, _e4223.member_7, _e4223.member_8, _e4223.member_9, _e4223.member_10, _e4223.member_11, _e4223.member_12, _e4223.member_13, _e4223.member_14, _e4223.member_15, _e4223.member_16, ((_e3920.member_17 & _e4238) | _e4237), _e4223.member_18, _e4223.member_19, _e4223.member_20, _e4223.member_21, _e4223.member_22, _e4223.member_23, _e4223.member_24, _e4223.member_25, _e4223.member_26, _e4223.member_27);
let _e4297 = type_25(_e4268.member, _e4268.member_1, _e4268.member_2, _e4268.member_3, _e4268.member_4, _e4268.member_5, _e4268.member_6, _e4268.member_7, _e4268.member_8, _e4268.member_9, _e4268.member_10, _e4268.member_11, _e4268.member_12, _e4268.member_13, _e4268.member_14, _e4268.member_15, _e4268.member_16, _e4268.member_17, (_e3920.member_18 & _e4238), _e4268.member_19, _e4268.member_20, _e4268.member_21, _e4268.member_22, _e4268.member_23, _e4268.member_24, _e4268.member_25, _e4268.member_26, _e4268.member_27);
phi_8149_ = type_25(_e4297.member, _e4297.member_1, _e4297.member_2, _e4297.member_3, _e4297.member_4, _e4297.member_5, _e4297.member_6, _e4297.member_7, _e4297.member_8, _e4297.member_9, _e4297.member_10, _e4297.member_11, _e4297.member_12, _e4297.member_13, _e4297.member_14, _e4297.member_15, _e4297.member_16, _e4297.member_17, _e4297.member_18, (_e4233 + -126i), _e4297.member_20, _e4297.member_21, _e4297.member_22, _e4297.member_23, _e4297.member_24, _e4297.member_25, _e4297.member_26, _e4297.member_27);
}
let _e4441 = phi_8149_;
let _e4447 = global_5.member.member_1.member;
let _e4449 = f32(bitcast<i32>(_e4447));
let _e4453 = global_5.member.member_1.member_1;
let _e4455 = f32(bitcast<i32>(_e4453));
let _e4465 = global_5.member.member_2.member;
let _e4466 = (((((f32(bitcast<i32>(_e121.x)) + 0.5f) / _e4449) * 2f) - 1f) * _e4465);
let _e4474 = global_5.member.member_2.member_1;
let _e4475 = ((1f - (((f32(bitcast<i32>(_e121.y)) + 0.5f) / _e4455) * 2f)) * _e4474);
let _e4478 = global_5.member.member_3;
let _e4487 = global_5.member.member_4;
let _e4494 = ((_e4478.member * _e4466) + (_e4487.member * _e4475));
let _e4495 = ((_e4478.member_1 * _e4466) + (_e4487.member_1 * _e4475));
let _e4496 = ((_e4478.member_2 * _e4466) + (_e4487.member_2 * _e4475));
let _e4500 = global_5.member.member_2.member_3;
let _e4501 = (_e4500 != 0u);
let _e4504 = global_5.member.member_5;
let _e4511 = select((_e4504.member + _e4494), _e4504.member, _e4501);
let _e4512 = select((_e4504.member_1 + _e4495), _e4504.member_1, _e4501);
let _e4513 = select((_e4504.member_2 + _e4496), _e4504.member_2, _e4501);
let _e4516 = global_5.member.member_6;
let _e4523 = select(_e4516.member, (_e4516.member + _e4494), _e4501);
let _e4524 = select(_e4516.member_1, (_e4516.member_1 + _e4495), _e4501);
let _e4525 = select(_e4516.member_2, (_e4516.member_2 + _e4496), _e4501);
let _e4531 = (((_e4511 * _e4511) + (_e4512 * _e4512)) + (_e4513 * _e4513));
let _e4535 = (1f / sqrt(select(0f, _e4531, (_e4531 > 0f))));
let _e4536 = (_e4511 * _e4535);
let _e4537 = (_e4512 * _e4535);
let _e4538 = (_e4513 * _e4535);
let _e4541 = ((2f * _e4465) / _e4449);
let _e4542 = (_e4478.member * _e4541);
let _e4543 = (_e4478.member_1 * _e4541);
let _e4544 = (_e4478.member_2 * _e4541);
let _e4546 = ((-2f * _e4474) / _e4455);
let _e4547 = (_e4487.member * _e4546);
let _e4548 = (_e4487.member_1 * _e4546);
let _e4549 = (_e4487.member_2 * _e4546);
let _e4562 = (((_e4542 * _e4536) + (_e4543 * _e4537)) + (_e4544 * _e4538));
let _e4572 = select(((_e4542 - (_e4536 * _e4562)) * _e4535), 0f, _e4501);
let _e4573 = select(((_e4543 - (_e4537 * _e4562)) * _e4535), 0f, _e4501);
let _e4574 = select(((_e4544 - (_e4538 * _e4562)) * _e4535), 0f, _e4501);
let _e4580 = (((_e4547 * _e4536) + (_e4548 * _e4537)) + (_e4549 * _e4538));
let _e4590 = select(((_e4547 - (_e4536 * _e4580)) * _e4535), 0f, _e4501);
let _e4591 = select(((_e4548 - (_e4537 * _e4580)) * _e4535), 0f, _e4501);
let _e4592 = select(((_e4549 - (_e4538 * _e4580)) * _e4535), 0f, _e4501);
let _e4601 = (1f / select(_e4536, select(1e-12f, -1e-12f, (_e4536 < 0f)), (bitcast<f32>((bitcast<u32>(_e4536) & 2147483647u)) < 1e-12f)));
let _e4609 = (1f / select(_e4537, select(1e-12f, -1e-12f, (_e4537 < 0f)), (bitcast<f32>((bitcast<u32>(_e4537) & 2147483647u)) < 1e-12f)));
let _e4617 = (1f / select(_e4538, select(1e-12f, -1e-12f, (_e4538 < 0f)), (bitcast<f32>((bitcast<u32>(_e4538) & 2147483647u)) < 1e-12f)));
let _e4620 = global_5.member.member_8;
let _e4626 = global_5.member.member_9;
let _e4631 = ((_e4620.member - _e4523) * _e4601);
let _e4633 = ((_e4626.member - _e4523) * _e4601);
let _e4635 = ((_e4620.member_1 - _e4524) * _e4609);
let _e4637 = ((_e4626.member_1 - _e4524) * _e4609);
let _e4639 = ((_e4620.member_2 - _e4525) * _e4617);
let _e4641 = ((_e4626.member_2 - _e4525) * _e4617);
let _e4643 = select(_e4633, _e4631, (_e4631 < _e4633));
let _e4645 = select(_e4637, _e4635, (_e4635 < _e4637));
let _e4647 = select(_e4645, _e4643, (_e4643 > _e4645));
let _e4649 = select(_e4641, _e4639, (_e4639 < _e4641));
let _e4651 = select(_e4649, _e4647, (_e4647 > _e4649));
let _e4653 = select(_e4633, _e4631, (_e4631 > _e4633));
let _e4655 = select(_e4637, _e4635, (_e4635 > _e4637));
let _e4657 = select(_e4655, _e4653, (_e4653 < _e4655));
let _e4659 = select(_e4641, _e4639, (_e4639 > _e4641));
let _e4663 = select(0f, _e4651, (_e4651 > 0f));
let _e4669 = ((((_e4011.member.member * _e4523) + (_e4011.member.member_1 * _e4524)) + (_e4011.member.member_2 * _e4525)) + _e4011.member_1);
let _e4675 = -((((_e4011.member.member * _e4536) + (_e4011.member.member_1 * _e4537)) + (_e4011.member.member_2 * _e4538)));
let _e4677 = (_e4675 > 1e-9f);
let _e4679 = select(1e-9f, _e4675, _e4677);
let _e4681 = ((_e4669 / _e4679) - 0.015625f);
let _e4684 = select(1e30f, select(0f, _e4681, (_e4681 > 0f)), ((_e4669 > 0f) && _e4677));
let _e4690 = ((((_e4048.member.member * _e4523) + (_e4048.member.member_1 * _e4524)) + (_e4048.member.member_2 * _e4525)) + _e4048.member_1);
let _e4696 = -((((_e4048.member.member * _e4536) + (_e4048.member.member_1 * _e4537)) + (_e4048.member.member_2 * _e4538)));
let _e4698 = (_e4696 > 1e-9f);
let _e4700 = select(1e-9f, _e4696, _e4698);
let _e4702 = ((_e4690 / _e4700) - 0.015625f);
let _e4705 = select(1e30f, select(0f, _e4702, (_e4702 > 0f)), ((_e4690 > 0f) && _e4698));
let _e4711 = ((select(_e4659, _e4657, (_e4657 < _e4659)) <= _e4663) || (true && (select(_e4684, _e4705, (_e4705 < _e4684)) <= _e4663)));
let _e4712 = select(_e4663, 0f, _e4711);
let _e4713 = (_e4536 * _e4712);
let _e4714 = (_e4537 * _e4712);
let _e4715 = (_e4538 * _e4712);
let _e4716 = (_e4523 + _e4713);
let _e4717 = (_e4524 + _e4714);
let _e4718 = (_e4525 + _e4715);
let _e4748 = type_25((vec3<f32>(_e4523, _e4524, _e4525) + vec3<f32>(_e4713, _e4714, _e4715)), _e4441.member_1, _e4441.member_2, _e4441.member_3, _e4441.member_4, _e4441.member_5, _e4441.member_6, _e4441.member_7, _e4441.member_8, _e4441.member_9, _e4441.member_10, _e4441.member_11, _e4441.member_12, _e4441.member_13, _e4441.member_14, _e4441.member_15, _e4441.member_16, _e4441.member_17, _e4441.member_18, _e4441.member_19, _e4441.member_20, _e4441.member_21, _e4441.member_22, _e4441.member_23, _e4441.member_24, _e4441.member_25, _e4441.member_26, _e4441.member_27);
let _e4776 = type_25(_e4748.member, vec3<f32>(_e4536, _e4537, _e4538), _e4748.member_2, _e4748.member_3, _e4748.member_4, _e4748.member_5, _e4748.member_6, _e4748.member_7, _e4748.member_8, _e4748.member_9, _e4748.member_10, _e4748.member_11, _e4748.member_12, _e4748.member_13, _e4748.member_14, _e4748.member_15, _e4748.member_16, _e4748.member_17, _e4748.member_18, _e4748.member_19, _e4748.member_20, _e4748.member_21, _e4748.member_22, _e4748.member_23, _e4748.member_24, _e4748.member_25, _e4748.member_26, _e4748.member_27);
let _e4814 = type_25(_e4776.member, _e4776.member_1, (vec3<f32>(select(0f, _e4542, _e4501), select(0f, _e4543, _e4501), select(0f, _e4544, _e4501)) + vec3<f32>((_e4572 * _e4712), (_e4573 * _e4712), (_e4574 * _e4712))), _e4776.member_3, _e4776.member_4, _e4776.member_5, _e4776.member_6, _e4776.member_7, _e4776.member_8, _e4776.member_9, _e4776.member_10, _e4776.member_11, _e4776.member_12, _e4776.member_13, _e4776.member_14, _e4776.member_15, _e4776.member_16, _e4776.member_17, _e4776.member_18, _e4776.member_19, _e4776.member_20, _e4776.member_21, _e4776.member_22, _e4776.member_23, _e4776.member_24, _e4776.member_25, _e4776.member_26, _e4776.member_27);
let _e4842 = type_25(_e4814.member, _e4814.member_1, _e4814.member_2, (vec3<f32>(select(0f, _e4547, _e4501), select(0f, _e4548, _e4501), select(0f, _e4549, _e4501)) + vec3<f32>((_e4590 * _e4712), (_e4591 * _e4712), (_e4592 * _e4712))), _e4814.member_4, _e4814.member_5, _e4814.member_6, _e4814.member_7, _e4814.member_8, _e4814.member_9, _e4814.member_10, _e4814.member_11, _e4814.member_12, _e4814.member_13, _e4814.member_14, _e4814.member_15, _e4814.member_16, _e4814.member_17, _e4814.member_18, _e4814.member_19, _e4814.member_20, _e4814.member_21, _e4814.member_22, _e4814.member_23, _e4814.member_24, _e4814.member_25, _e4814.member_26, _e4814.member_27);
let _e4870 = type_25(_e4842.member, _e4842.member_1, _e4842.member_2, _e4842.member_3, vec3<f32>(_e4572, _e4573, _e4574), _e4842.member_5, _e4842.member_6, _e4842.member_7, _e4842.member_8, _e4842.member_9, _e4842.member_10, _e4842.member_11, _e4842.member_12, _e4842.member_13, _e4842.member_14, _e4842.member_15, _e4842.member_16, _e4842.member_17, _e4842.member_18, _e4842.member_19, _e4842.member_20, _e4842.member_21, _e4842.member_22, _e4842.member_23, _e4842.member_24, _e4842.member_25, _e4842.member_26, _e4842.member_27);
let _e4898 = type_25(_e4870.member, _e4870.member_1, _e4870.member_2, _e4870.member_3, _e4870.member_4, vec3<f32>(_e4590, _e4591, _e4592), _e4870.member_6, _e4870.member_7, _e4870.member_8, _e4870.member_9, _e4870.member_10, _e4870.member_11, _e4870.member_12, _e4870.member_13, _e4870.member_14, _e4870.member_15, _e4870.member_16, _e4870.member_17, _e4870.member_18, _e4870.member_19, _e4870.member_20, _e4870.member_21, _e4870.member_22, _e4870.member_23, _e4870.member_24, _e4870.member_25, _e4870.member_26, _e4870.member_27);
let _e4926 = type_25(_e4898.member, _e4898.member_1, _e4898.member_2, _e4898.member_3, _e4898.member_4, _e4898.member_5, _e4898.member_6, 0i, _e4898.member_8, _e4898.member_9, _e4898.member_10, _e4898.member_11, _e4898.member_12, _e4898.member_13, _e4898.member_14, _e4898.member_15, _e4898.member_16, _e4898.member_17, _e4898.member_18, _e4898.member_19, _e4898.member_20, _e4898.member_21, _e4898.member_22, _e4898.member_23, _e4898.member_24, _e4898.member_25, _e4898.member_26, _e4898.member_27);
let _e4954 = type_25(_e4926.member, _e4926.member_1, _e4926.member_2, _e4926.member_3, _e4926.member_4, _e4926.member_5, _e4926.member_6, _e4926.member_7, _e4926.member_8, _e4926.member_9, _e4926.member_10, _e4926.member_11, _e4926.member_12, _e4926.member_13, _e4926.member_14, _e4926.member_15, 0i, _e4926.member_17, _e4926.member_18, _e4926.member_19, _e4926.member_20, _e4926.member_21, _e4926.member_22, _e4926.member_23, _e4926.member_24, _e4926.member_25, _e4926.member_26, _e4926.member_27);
let _e4982 = type_25(_e4954.member, _e4954.member_1, _e4954.member_2, _e4954.member_3, _e4954.member_4, _e4954.member_5, _e4954.member_6, _e4954.member_7, _e4954.member_8, _e4954.member_9, _e4954.member_10, _e4954.member_11, _e4954.member_12, _e4954.member_13, _e4954.member_14, 1f, _e4954.member_16, _e4954.member_17, _e4954.member_18, _e4954.member_19, _e4954.member_20, _e4954.member_21, _e4954.member_22, _e4954.member_23, _e4954.member_24, _e4954.member_25, _e4954.member_26, _e4954.member_27);
let _e5010 = type_25(_e4982.member, _e4982.member_1, _e4982.member_2, _e4982.member_3, _e4982.member_4, _e4982.member_5, _e4982.member_6, _e4982.member_7, _e4982.member_8, _e4982.member_9, _e4982.member_10, _e4982.member_11, _e4982.member_12, 0f, _e4982.member_14, _e4982.member_15, _e4982.member_16, _e4982.member_17, _e4982.member_18, _e4982.member_19, _e4982.member_20, _e4982.member_21, _e4982.member_22, _e4982.member_23, _e4982.member_24, _e4982.member_25, _e4982.member_26, _e4982.member_27);
let _e5038 = type_25(_e5010.member, _e5010.member_1, _e5010.member_2, _e5010.member_3, _e5010.member_4, _e5010.member_5, _e5010.member_6, _e5010.member_7, _e5010.member_8, _e5010.member_9, _e5010.member_10, 0i, _e5010.member_12, _e5010.member_13, _e5010.member_14, _e5010.member_15, _e5010.member_16, _e5010.member_17, _e5010.member_18, _e5010.member_19, _e5010.member_20, _e5010.member_21, _e5010.member_22, _e5010.member_23, _e5010.member_24, _e5010.member_25, _e5010.member_26, _e5010.member_27);
let _e5066 = type_25(_e5038.member, _e5038.member_1, _e5038.member_2, _e5038.member_3, _e5038.member_4, _e5038.member_5, _e5038.member_6, _e5038.member_7, _e5038.member_8, _e5038.member_9, _e5038.member_10, _e5038.member_11, 0i, _e5038.member_13, _e5038.member_14, _e5038.member_15, _e5038.member_16, _e5038.member_17, _e5038.member_18, _e5038.member_19, _e5038.member_20, _e5038.member_21, _e5038.member_22, _e5038.member_23, _e5038.member_24, _e5038.member_25, _e5038.member_26, _e5038.member_27);
let _e5072 = ((((_e4011.member.member * _e4716) + (_e4011.member.member_1 * _e4717)) + (_e4011.member.member_2 * _e4718)) + _e4011.member_1);
let _e5076 = ((_e5072 / _e4679) - 0.015625f);
let _e5079 = select(1e30f, select(0f, _e5076, (_e5076 > 0f)), ((_e5072 > 0f) && _e4677));
let _e5085 = ((((_e4048.member.member * _e4716) + (_e4048.member.member_1 * _e4717)) + (_e4048.member.member_2 * _e4718)) + _e4048.member_1);
let _e5089 = ((_e5085 / _e4700) - 0.015625f);
let _e5092 = select(1e30f, select(0f, _e5089, (_e5089 > 0f)), ((_e5085 > 0f) && _e4698));
let _e5096 = (_e5092 < _e5079);
let _e5127 = type_25(_e5066.member, _e5066.member_1, _e5066.member_2, _e5066.member_3, _e5066.member_4, _e5066.member_5, _e5066.member_6, _e5066.member_7, 0i, _e5066.member_9, _e5066.member_10, _e5066.member_11, _e5066.member_12, _e5066.member_13, _e5066.member_14, _e5066.member_15, _e5066.member_16, _e5066.member_17, _e5066.member_18, _e5066.member_19, _e5066.member_20, _e5066.member_21, _e5066.member_22, _e5066.member_23, _e5066.member_24, _e5066.member_25, _e5066.member_26, _e5066.member_27);
let _e5155 = type_25(_e5127.member, _e5127.member_1, _e5127.member_2, _e5127.member_3, _e5127.member_4, _e5127.member_5, _e5127.member_6, _e5127.member_7, _e5127.member_8, select(select(-2i, -3i, _e5096), -1i, ((_e5079 >= 1e30f) && (_e5092 >= 1e30f))), _e5127.member_10, _e5127.member_11, _e5127.member_12, _e5127.member_13, _e5127.member_14, _e5127.member_15, _e5127.member_16, _e5127.member_17, _e5127.member_18, _e5127.member_19, _e5127.member_20, _e5127.member_21, _e5127.member_22, _e5127.member_23, _e5127.member_24, _e5127.member_25, _e5127.member_26, _e5127.member_27);
let _e5183 = type_25(_e5155.member, _e5155.member_1, _e5155.member_2, _e5155.member_3, _e5155.member_4, _e5155.member_5, _e5155.member_6, _e5155.member_7, _e5155.member_8, _e5155.member_9, select(_e5079, _e5092, _e5096), _e5155.member_11, _e5155.member_12, _e5155.member_13, _e5155.member_14, _e5155.member_15, _e5155.member_16, _e5155.member_17, _e5155.member_18, _e5155.member_19, _e5155.member_20, _e5155.member_21, _e5155.member_22, _e5155.member_23, _e5155.member_24, _e5155.member_25, _e5155.member_26, _e5155.member_27);
let _e5187 = global_5.member.member_13.member_4;
let _e5194 = global_5.member.member_13.member_5;
let _e5199 = ((_e5187.member - _e4523) * _e4601);
let _e5201 = ((_e5194.member - _e4523) * _e4601);
let _e5203 = ((_e5187.member_1 - _e4524) * _e4609);
let _e5205 = ((_e5194.member_1 - _e4524) * _e4609);
let _e5207 = ((_e5187.member_2 - _e4525) * _e4617);
let _e5209 = ((_e5194.member_2 - _e4525) * _e4617);
let _e5211 = select(_e5201, _e5199, (_e5199 < _e5201));
let _e5213 = select(_e5205, _e5203, (_e5203 < _e5205));
let _e5215 = select(_e5213, _e5211, (_e5211 > _e5213));
let _e5217 = select(_e5209, _e5207, (_e5207 < _e5209));
let _e5219 = select(_e5217, _e5215, (_e5215 > _e5217));
let _e5221 = select(_e5201, _e5199, (_e5199 > _e5201));
let _e5223 = select(_e5205, _e5203, (_e5203 > _e5205));
let _e5225 = select(_e5223, _e5221, (_e5221 < _e5223));
let _e5227 = select(_e5209, _e5207, (_e5207 > _e5209));
let _e5229 = select(_e5227, _e5225, (_e5225 < _e5227));
let _e5231 = select(0f, _e5219, (_e5219 > 0f));
let _e5233 = select(_e4712, _e5229, (_e5229 < _e4712));
let _e5234 = (_e5233 > _e5231);
let _e5237 = (select(0f, _e5233, _e5234) - select(0f, _e5231, _e5234));
let _e5241 = global_5.member.member_13.member;
let _e5246 = -((_e5241.member * _e5237));
let _e5248 = select(-87f, _e5246, (_e5246 > -87f));
let _e5250 = select(88f, _e5248, (_e5248 < 88f));
let _e5252 = ((_e5250 * 1.442695f) + 0.5f);
let _e5254 = select(-127f, _e5252, (_e5252 > -127f));
let _e5256 = select(128f, _e5254, (_e5254 < 128f));
let _e5263 = select(0i, select(select(i32(_e5256), i32(-2147483648), (_e5256 < -2147483600f)), 2147483647i, (_e5256 > 2147483500f)), (_e5256 == _e5256));
let _e5267 = (_e5263 - select(0i, 1i, (_e5256 < f32(_e5263))));
let _e5268 = f32(_e5267);
let _e5272 = ((_e5250 - (_e5268 * 0.6933594f)) - (_e5268 * -2.1219444e-4f));
let _e5294 = -((_e5241.member_1 * _e5237));
let _e5296 = select(-87f, _e5294, (_e5294 > -87f));
let _e5298 = select(88f, _e5296, (_e5296 < 88f));
let _e5300 = ((_e5298 * 1.442695f) + 0.5f);
let _e5302 = select(-127f, _e5300, (_e5300 > -127f));
let _e5304 = select(128f, _e5302, (_e5302 < 128f));
let _e5311 = select(0i, select(select(i32(_e5304), i32(-2147483648), (_e5304 < -2147483600f)), 2147483647i, (_e5304 > 2147483500f)), (_e5304 == _e5304));
let _e5315 = (_e5311 - select(0i, 1i, (_e5304 < f32(_e5311))));
let _e5316 = f32(_e5315);
let _e5320 = ((_e5298 - (_e5316 * 0.6933594f)) - (_e5316 * -2.1219444e-4f));
let _e5342 = -((_e5241.member_2 * _e5237));
let _e5344 = select(-87f, _e5342, (_e5342 > -87f));
let _e5346 = select(88f, _e5344, (_e5344 < 88f));
let _e5348 = ((_e5346 * 1.442695f) + 0.5f);
let _e5350 = select(-127f, _e5348, (_e5348 > -127f));
let _e5352 = select(128f, _e5350, (_e5350 < 128f));
let _e5359 = select(0i, select(select(i32(_e5352), i32(-2147483648), (_e5352 < -2147483600f)), 2147483647i, (_e5352 > 2147483500f)), (_e5352 == _e5352));
let _e5363 = (_e5359 - select(0i, 1i, (_e5352 < f32(_e5359))));
let _e5364 = f32(_e5363);
let _e5368 = ((_e5346 - (_e5364 * 0.6933594f)) - (_e5364 * -2.1219444e-4f));
let _e5391 = (1f / 3f);
let _e5393 = (1f * ((1f + (_e5272 * (1f + (_e5272 * (0.5f + (_e5272 * (0.16666667f + (_e5272 * (0.041666668f + (_e5272 * (0.008333334f + (_e5272 * (0.001388889f + (_e5272 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5267 + 127i)) << bitcast<u32>(23i)))));
let _e5394 = (1f * ((1f + (_e5320 * (1f + (_e5320 * (0.5f + (_e5320 * (0.16666667f + (_e5320 * (0.041666668f + (_e5320 * (0.008333334f + (_e5320 * (0.001388889f + (_e5320 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5315 + 127i)) << bitcast<u32>(23i)))));
let _e5395 = (1f * ((1f + (_e5368 * (1f + (_e5368 * (0.5f + (_e5368 * (0.16666667f + (_e5368 * (0.041666668f + (_e5368 * (0.008333334f + (_e5368 * (0.001388889f + (_e5368 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5363 + 127i)) << bitcast<u32>(23i)))));
let _e5424 = type_25(_e5183.member, _e5183.member_1, _e5183.member_2, _e5183.member_3, _e5183.member_4, _e5183.member_5, vec3<f32>(_e5393, _e5394, _e5395), _e5183.member_7, _e5183.member_8, _e5183.member_9, _e5183.member_10, _e5183.member_11, _e5183.member_12, _e5183.member_13, _e5183.member_14, _e5183.member_15, _e5183.member_16, _e5183.member_17, _e5183.member_18, _e5183.member_19, _e5183.member_20, _e5183.member_21, _e5183.member_22, _e5183.member_23, _e5183.member_24, _e5183.member_25, _e5183.member_26, _e5183.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e4441.member_20) {
phi_9384_ = ((((1f + 1f) + 1f) * _e5391) - (((_e5393 + _e5394) + _e5395) * _e5391));
} else {
phi_9384_ = 0f;
}
let _e5434 = phi_9384_;
let _e5464 = type_25(_e5424.member, _e5424.member_1, _e5424.member_2, _e5424.member_3, _e5424.member_4, _e5424.member_5, _e5424.member_6, _e5424.member_7, _e5424.member_8, _e5424.member_9, _e5424.member_10, _e5424.member_11, _e5424.member_12, _e5424.member_13, _e5424.member_14, _e5424.member_15, _e5424.member_16, _e5424.member_17, _e5424.member_18, _e5424.member_19, _e5424.member_20, _e5424.member_21, _e5424.member_22, _e5424.member_23, _e5424.member_24, _e5424.member_25, (_e4441.member_26 + _e5434), _e5424.member_27);
if _e4711 {
phi_9411_ = type_25(_e5464.member, _e5464.member_1, _e5464.member_2, _e5464.member_3, _e5464.member_4, _e5464.member_5, _e5464.member_6, _e5464.member_7, _e1381, _e5464.member_9, _e5464.member_10, _e5464.member_11, _e5464.member_12, _e5464.member_13, _e5464.member_14, _e5464.member_15, _e5464.member_16, _e5464.member_17, _e5464.member_18, _e5464.member_19, _e5464.member_20, _e5464.member_21, _e5464.member_22, _e5464.member_23, _e5464.member_24, _e5464.member_25, _e5464.member_26, _e5464.member_27);
} else {
phi_9411_ = _e5464;
}
let _e5494 = phi_9411_;
phi_9412_ = _e5494;
}
let _e5524 = phi_9412_;
phi_9413_ = _e5524;
} else {
phi_9413_ = _e4165;
}
let _e5526 = phi_9413_;
phi_9414_ = type_25();
phi_9415_ = _e5526;
}
let _e5804 = phi_9414_;
let _e5806 = phi_9415_;
phi_9416_ = _e5804;
phi_9417_ = _e5806;
phi_9418_ = _e2120;
}
let _e7217 = phi_9416_;
let _e7219 = phi_9417_;
let _e7221 = phi_9418_;
if _e7221 {
phi_9422_ = _e7217;
} else {
phi_9422_ = _e7219;
}
let _e7223 = phi_9422_;
phi_9423_ = _e7223;
}
let _e7283 = phi_9423_;
phi_9425_ = _e7283;
phi_9426_ = select(false, _e1419, _e1462);
}
let _e8139 = phi_9425_;
let _e8141 = phi_9426_;
phi_2429_ = _e8139;
phi_2432_ = (_e1417 + 1i);
phi_2434_ = _e8141;
} else {
phi_2429_ = type_25();
phi_2432_ = i32();
phi_2434_ = bool();
}
let _e8143 = phi_2429_;
let _e8145 = phi_2432_;
let _e8147 = phi_2434_;
continue;
continuing {
phi_2428_ = _e8143;
phi_2431_ = _e8145;
phi_2433_ = _e8147;
break if !(_e1423);
}
}
let _e8150 = local_10;
let _e8154 = local_11;
let _e8158 = local_12;
let _e8162 = local_13;
let _e8166 = local_14;
let _e8170 = local_15;
let _e8174 = local_16;
let _e8178 = local_17;
let _e8182 = local_18;
let _e8186 = local_19;
let _e8190 = local_20;
let _e8194 = local_21;
let _e8198 = local_22;
let _e8202 = local_23;
let _e8206 = local_24;
let _e8210 = local_25;
let _e8214 = local_26;
let _e8218 = local_27;
let _e8222 = local_28;
let _e8226 = local_29;
let _e8230 = local_30;
let _e8234 = local_31;
let _e8238 = local_32;
let _e8242 = local_33;
let _e8246 = local_34;
let _e8249 = local_35;
let _e8253 = local_36;
let _e8257 = local_37;
let _e8260 = local_38;
let _e8263 = local_39;
let _e8267 = local_40;
let _e8271 = local_41;
let _e8275 = local_42;
let _e8279 = local_43;
let _e8283 = local_44;
let _e8287 = local_45;
let _e8291 = local_46;
let _e8294 = local_47;
let _e8297 = local_48;
let _e8300 = local_49;
let _e8303 = local_50;
global_4.member[_e143] = _e8150.member.x;
global_4.member[_e155] = _e8154.member.y;
global_4.member[_e166] = _e8158.member.z;
global_4.member[_e177] = _e8162.member_1.x;
global_4.member[_e188] = _e8166.member_1.y;
global_4.member[_e199] = _e8170.member_1.z;
global_4.member[_e210] = _e8174.member_2.x;
global_4.member[_e221] = _e8178.member_2.y;
global_4.member[_e232] = _e8182.member_2.z;
global_4.member[_e243] = _e8186.member_3.x;
global_4.member[_e254] = _e8190.member_3.y;
global_4.member[_e265] = _e8194.member_3.z;
global_4.member[_e276] = _e8198.member_4.x;
global_4.member[_e287] = _e8202.member_4.y;
global_4.member[_e298] = _e8206.member_4.z;
global_4.member[_e309] = _e8210.member_5.x;
global_4.member[_e320] = _e8214.member_5.y;
global_4.member[_e331] = _e8218.member_5.z;
global_4.member[_e342] = _e8222.member_6.x;
global_4.member[_e353] = _e8226.member_6.y;
global_4.member[_e364] = _e8230.member_6.z;
global_4.member[_e375] = f32(_e8234.member_7);
global_4.member[_e386] = f32(_e8238.member_8);
global_4.member[_e397] = f32(_e8242.member_9);
global_4.member[_e408] = _e8246.member_10;
global_4.member[_e419] = f32(_e8249.member_11);
global_4.member[_e430] = f32(_e8253.member_12);
global_4.member[_e441] = _e8257.member_13;
global_4.member[_e452] = _e8260.member_14;
let _e8366 = local_51;
global_4.member[_e463] = _e8366;
global_4.member[_e474] = f32(_e8263.member_16);
global_4.member[_e485] = f32(_e8267.member_17);
global_4.member[_e496] = f32(_e8271.member_18);
global_4.member[_e507] = f32(_e8275.member_19);
global_4.member[_e518] = f32(_e8279.member_20);
global_4.member[_e529] = f32(_e8283.member_21);
global_4.member[_e540] = f32(_e8287.member_22);
global_4.member[_e551] = _e8291.member_23;
global_4.member[_e562] = _e8294.member_24;
global_4.member[_e573] = _e8297.member_25;
global_4.member[_e584] = _e8300.member_26;
global_4.member[_e595] = _e8303.member_27;
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
